import { describe, expect, it } from 'vitest';
import { differenceOf } from '../../src/model/plan/list_difference';

const list = (rows: string[], comment: string): string => `# ${comment}\nbehavior_name=goto_list\n<start:waypoints>\n${rows.join('\n')}\n<end:waypoints>\n`;

describe('the difference of two lists', () => {
  it('names rows that are in one of them alone', () => {
    const lines = differenceOf(list(['-5236.0 6909.0', '-5212.0 6907.0'], 'new'), list(['-5236.0 6909.0', '-5200.0 6907.0'], 'new'));
    expect(lines.filter(({ side }) => side === 'other').map(({ text }) => text)).toEqual(['-5200.0 6907.0']);
    expect(lines.filter(({ side }) => side === 'this').map(({ text }) => text)).toEqual(['-5212.0 6907.0']);
    expect(lines.filter(({ side }) => side === 'both')).toHaveLength(4);
  });

  it('is none where comments, line ends and blanks at the end alone differ', () => {
    const lines = differenceOf(list(['-5236.0 6909.0'], 'today'), list(['-5236.0\t6909.0 '], 'a year ago').replaceAll('\n', '\r\n'));
    expect(lines.every(({ side }) => side === 'both')).toBe(true);
  });
});
