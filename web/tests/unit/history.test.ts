import { describe, expect, it } from 'vitest';
import { begin, record, redo, undo } from '../../src/model/history';

describe('a history', () => {
  it('is the same after undo and redo', () => {
    const history = record(record(begin('a'), 'b'), 'c');
    expect(redo(undo(history))).toEqual(history);
    expect(redo(redo(undo(undo(history))))).toEqual(history);
  });

  it('stays as it is where there is nothing to undo or redo', () => {
    const history = begin('a');
    expect(undo(history)).toBe(history);
    expect(redo(history)).toBe(history);
  });

  it('forgets what was undone at a new step', () => {
    const history = record(undo(record(begin('a'), 'b')), 'c');
    expect(history).toEqual({ past: ['a'], now: 'c', future: [] });
  });
});
