import type { FrameState } from 'ol/Map.js';
import VectorLayer, { type Options } from 'ol/layer/Vector.js';
import CanvasVectorLayerRenderer from 'ol/renderer/canvas/VectorLayer.js';
import type VectorSource from 'ol/source/Vector.js';
import { LastDrawn } from './last_drawn';

let made = 0;

/**
 * A layer of features on its own canvas, redrawn only when its features or the view have changed. OpenLayers redraws
 * every layer in every frame, but while the clock plays most layers stay the same.
 */
export class StillLayer extends VectorLayer<VectorSource> {
  constructor(options: Options<VectorSource>) {
    super({ ...options, className: `still-layer-${++made}` }); // a unique class name gives it its own canvas
  }

  /**
   * Without features no canvas is drawn, but the frame is prepared, so that removed features are no longer found under
   * the pointer.
   */
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
  private readonly drawn = new LastDrawn();
  private picture: HTMLElement | undefined;

  override renderFrame(state: FrameState): HTMLElement {
    const { center, resolution, rotation } = state.viewState;
    // At the end of a movement the features are laid out again for the same view.
    const isDrawn = this.drawn.isFor(...state.size, state.pixelRatio, ...center, resolution, rotation, ...state.viewHints, this.getLayer().getRevision());
    if (this.picture && isDrawn) return this.picture;
    return (this.picture = super.renderFrame(state, null));
  }
}
