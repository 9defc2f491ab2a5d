import type { FrameState } from 'ol/Map.js';
import VectorLayer, { type Options } from 'ol/layer/Vector.js';
import CanvasVectorLayerRenderer from 'ol/renderer/canvas/VectorLayer.js';
import type VectorSource from 'ol/source/Vector.js';

let made = 0;

/**
 * A layer of features on a canvas of its own, drawn anew only where its features or the view have changed. OpenLayers draws every
 * layer in every frame, and while the clock plays most of them stay as they are.
 */
export class StillLayer extends VectorLayer<VectorSource> {
  constructor(options: Options<VectorSource>) {
    super({ ...options, className: `still-layer-${++made}` }); // a class of its own keeps other layers off its canvas
  }

  /** Without features it needs no canvas; but nothing that was there is found under the pointer any more. */
  override render(state: FrameState | null, target: HTMLElement): HTMLElement | null {
    if (this.getSource()?.isEmpty() === false) return super.render(state, target);
    if (state) this.getRenderer()?.prepareFrame(state);
    return null;
  }

  override createRenderer(): CanvasVectorLayerRenderer {
    return new StillRenderer(this);
  }
}

class StillRenderer extends CanvasVectorLayerRenderer {
  private drawn = '';
  private picture: HTMLElement | undefined;

  override renderFrame(state: FrameState): HTMLElement {
    const { center, resolution, rotation } = state.viewState;
    // With the end of a movement features are laid out anew for the same view.
    const wanted = [...state.size, state.pixelRatio, ...center, resolution, rotation, ...state.viewHints, this.getLayer().getRevision()].join();
    if (this.picture && wanted === this.drawn) return this.picture;
    this.drawn = wanted;
    return (this.picture = super.renderFrame(state, null));
  }
}
