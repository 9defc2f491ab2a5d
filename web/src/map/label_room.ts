/** The name of a place on the map, in units of the projection. */
export interface Label {
  at: number[];
  text: string;
}

/** Size of a name in bold figures of 11 px: its height with the halo, and the width of a figure. */
const height_px = 18;
const figure_px = 7;
const gap_px = 4;

const reach_px = ({ text }: Label): number => Math.max(height_px, figure_px * text.length + gap_px);

/**
 * Which names have room beside each other at a resolution, whatever the rotation; earlier names in the list have
 * priority. OpenLayers could do this, too, but would then paint every layer twice in each frame.
 */
export function labelsWithRoom(labels: Label[]): (resolution: number) => ReadonlySet<Label> {
  let known: { resolution: number; withRoom: Set<Label> } | undefined;
  return (resolution) => {
    if (known?.resolution === resolution) return known.withRoom;
    const withRoom = new Set<Label>();
    for (const label of labels) {
      const isFree = [...withRoom].every((other) => {
        const apart_px = Math.hypot((label.at[0] ?? 0) - (other.at[0] ?? 0), (label.at[1] ?? 0) - (other.at[1] ?? 0)) / resolution;
        return apart_px >= Math.max(reach_px(label), reach_px(other));
      });
      if (isFree) withRoom.add(label);
    }
    known = { resolution, withRoom };
    return withRoom;
  };
}
