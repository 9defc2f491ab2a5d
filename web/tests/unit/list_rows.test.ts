import { describe, expect, it } from 'vitest';
import { listRows } from '../../src/model/plan/list_rows';

const file = (name: string, first: number, last: number): { name: string; text: string } => ({
  name, text: `behavior_name=goto_list\n# ${name}, list 1 of 2: waypoints ${first} to ${last} of 5\n# plan x\n`,
});

describe('the rows of waypoint lists', () => {
  it('begin anew in each file, and the start is in none', () => {
    const rows = listRows([file('goto_l10.ma', 1, 2), file('goto_l11.ma', 3, 5), { name: 'readme.txt', text: 'waypoints 1 to 9 of 9' }]);

    expect(rows.map(({ label, index, file: name, row }) => `${label} ${index} ${name} ${row ?? '-'}`)).toEqual([
      'S 0  -', '1 1 goto_l10.ma 0', '2 2 goto_l10.ma 1', '3 3 goto_l11.ma 0', '4 4 goto_l11.ma 1', '5 5 goto_l11.ma 2',
    ]);
  });

  it('say which list keeps the vehicle at a waypoint', () => {
    const hold = { name: 'goto_l11.ma', text: 'behavior_name=goto_list\n# goto_l11.ma, list 2 of 3: hold at waypoint 2 of 5\n' };

    const rows = listRows([file('goto_l10.ma', 1, 2), hold, file('goto_l12.ma', 3, 5)]);

    expect(rows.filter(({ holds }) => holds)).toEqual([{ label: '2', index: 2, file: 'goto_l11.ma', row: undefined, holds: true }]);
    expect(rows.map(({ index }) => index)).toEqual([0, 1, 2, 2, 3, 4, 5]);
  });

  it('are not told of files that do not say what they hold', () => {
    expect(listRows([{ name: 'plan.imc', text: '' }])).toEqual([]);
  });
});
