import { signal } from '@preact/signals';
import type { Box, Position } from '../contract/data_types';
import { contains } from '../geo/boxes';
import { parsePosition, type Parsed } from '../geo/coordinates';

/** The area of the stored data that a plan needs; undefined if it is not known yet or there are no data. */
export const dataArea = signal<Box | undefined>(undefined);

const isNear = ([lon, lat]: Position): boolean => !dataArea.value || contains(dataArea.value, [lon, lat, lon, lat]);

/** Reads a position from a field. Asks whether latitude and longitude are swapped where they seem to be. */
export const readPosition = (text: string): Parsed<Position> => parsePosition(text, isNear);
