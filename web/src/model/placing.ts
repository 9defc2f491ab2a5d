import type { Position } from '../contract/data_types';
import { editablePosition } from '../geo/coordinates';
import { draft, edit } from './setup/draft';
import { addSafePlace } from './plan/export_options';
import { changeBerg } from './hand_made';
import { announce, dialog } from './screen';
import { tool } from './view';

/** Passes a place on the map to the tool that waits for one. `probe` is called for the probe tool. */
export function takePlace(place: Position, probe: (place: Position) => void): void {
  const written = editablePosition(place);
  switch (tool.peek()) {
    case 'from':
    case 'to': {
      const field = tool.peek() === 'from' ? 'from' : 'to';
      edit({ [field]: written });
      announce(`${field === 'from' ? 'Start' : 'Goal'} set to ${written}.`);
      tool.value = field === 'from' && draft.peek().to.trim() === '' ? 'to' : 'pan';
      return;
    }
    case 'via':
      edit({ via: [...draft.peek().via.split('\n').filter((line) => line.trim() !== ''), written].join('\n') });
      announce(`Via point at ${written}.`);
      return;
    case 'berg':
      changeBerg({ place: written });
      announce(`Iceberg at ${written}.`);
      tool.value = 'pan';
      return;
    case 'safe':
      addSafePlace(written);
      tool.value = 'pan';
      dialog.value = 'export';
      return;
    case 'probe':
      probe(place);
      return;
    case 'area':
    case 'zone': // the drawing tool handles it
    case 'pan':
  }
}
