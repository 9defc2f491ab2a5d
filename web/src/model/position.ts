import { signal } from '@preact/signals';
import type { Box, Position } from '../api/data_types';
import { contains } from '../geo/boxes';
import { parsePosition, type Parsed } from '../geo/coordinates';

/** Where data are stored that a plan needs; undefined: not known yet, or nowhere. */
export const dataArea = signal<Box | undefined>(undefined);

const isNear = ([lon, lat]: Position): boolean => !dataArea.value || contains(dataArea.value, [lon, lat, lon, lat]);

/** A position typed into a field, with a question where its figures seem to stand in the wrong order. */
export const readPosition = (text: string): Parsed<Position> => parsePosition(text, isNear);
