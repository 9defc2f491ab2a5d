import { describe, expect, it, vi } from 'vitest';
import { forgetChanges, lastDone, lastUndone, redo, remember, undo, type Change } from '../../src/model/undo';

let value = '';
const write = (next: string, more: Partial<Change> = {}): void => {
  const before = value;
  value = next;
  remember({
    title: `writing ${next}`,
    back: () => {
      value = before;
    },
    again: () => {
      value = next;
    },
    ...more,
  });
};

describe('undo', () => {
  it('takes changes back in turn, whatever they belong to, and makes them again', () => {
    write('a', { of: 'a plan' });
    write('b', { of: 'the set-up' });
    expect(undo()?.title).toBe('writing b');
    expect(value).toBe('a');
    undo();
    expect(value).toBe('');
    redo();
    redo();
    expect(value).toBe('b');
    expect(redo()).toBeUndefined();
  });

  it('forgets what was undone at a new change', () => {
    undo();
    write('c');
    expect(lastUndone.value).toBeUndefined();
  });

  it('takes letters that follow on from each other for one change, until something is undone', () => {
    write('d', { typing: 'field' });
    write('de', { typing: 'field' });
    write('def', { typing: 'field' });
    undo();
    expect(value).toBe('c');
    redo();
    write('defg', { typing: 'field' });
    undo();
    expect(value).toBe('def');
  });

  it('forgets what belongs to something that is gone', () => {
    write('g', { of: 'gone' });
    forgetChanges('gone');
    expect(lastDone.value?.title).toBe('writing def');
  });

  it('waits for the server before it takes the next change back', async () => {
    let answer = (): void => undefined;
    write('h');
    write('i', { back: () => new Promise((resolve) => (answer = resolve)) });
    undo();
    undo();
    expect(value).toBe('i');
    answer();
    await vi.waitFor(() => expect(value).toBe('g'));
  });
});
