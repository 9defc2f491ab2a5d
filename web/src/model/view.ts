import { signal } from '@preact/signals';
import type { Box, IcebergFeature, Position } from '../contract/data_types';

/** What the map shows now. The map itself sets it. */
export interface View {
  box: Box; // around everything in view
  centre: Position;
  width_px: number;
  height_px: number;
  metresPerPixel: number; // true metres at the centre
  north_deg: number; // direction of true north on the screen at the centre, clockwise from up
}

export const view = signal<View | undefined>(undefined);
export const pointer = signal<Position | undefined>(undefined);

/** How far the tools at the map's upper left reach from that corner. The panel of the map sets it. */
export const toolsReach_px = signal({ right: 0, bottom: 0 });

/** Height of the note that covers the lower edge of the map on a narrow screen. The panel of the map sets it. */
export const noteHeight_px = signal(0);

/**
 * Size of the unfolded legend at the map's lower right, none while it is folded; undefined until it was laid out. The
 * legend sets it.
 */
export const legendSize_px = signal<{ width: number; height: number } | undefined>(undefined);

/** About the size of the legend with all data, before it is laid out. */
export const expectedLegend_px = { width: 216, height: 380 };

/** How far the arrow of north and the cards below it reach down the map. The panel of the map sets it. */
export const cardsBottom_px = signal(0);

/** The berg under the pointer. */
export const hoveredBerg = signal<IcebergFeature | undefined>(undefined);

export type Tool = 'pan' | 'from' | 'to' | 'via' | 'area' | 'berg' | 'zone' | 'probe' | 'safe';
export const tool = signal<Tool>('pan');

/** An order to the map. Each new object is carried out once. */
export type Command =
  | { do: 'fit'; places: Position[] }
  | { do: 'centre'; place: Position }
  | { do: 'zoom'; by: number }
  | { do: 'north' };

export const command = signal<Command | undefined>(undefined);
export const ask = (wish: Command): void => {
  command.value = wish;
};
