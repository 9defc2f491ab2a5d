import { describe, expect, it } from 'vitest';
import type { Message } from '../../src/contract/types';
import { messagesOf, ofRank, showMessage, warnedOf } from '../../src/model/messages';
import { command } from '../../src/model/view';

const message = (rank: Message['rank'], text: string, place: Message['place'] = null): Message => ({ code: 'some-code', rank, place, values: {}, text });

describe('what the server tells', () => {
  const told = {
    messages: [message('danger', 'a'), message('caution', 'b'), message('note', 'c'), message('note', 'd')],
    dangers: ['Danger: a'],
    warnings: ['Danger: a', 'b', 'c', 'd'],
  };

  it('has the ranks of its messages, and notes are not read out', () => {
    expect(ofRank(told, 'danger').map(({ text }) => text)).toEqual(['a']);
    expect(ofRank(told, 'caution').map(({ text }) => text)).toEqual(['b']);
    expect(ofRank(told, 'note').map(({ text }) => text)).toEqual(['c', 'd']);
    expect(warnedOf(told)).toBe(' 1 danger. 1 caution.');
  });

  it('is told by its sentences in answers stored before messages had codes, each once', () => {
    const sentences = messagesOf({ dangers: ['Danger: a'], warnings: ['Danger: a', 'b', 'c'] });

    expect(sentences.map(({ rank, text }) => `${rank}: ${text}`)).toEqual(['danger: a', 'caution: b', 'caution: c']);
    expect(warnedOf({ warnings: ['b', 'c'] })).toBe(' 2 cautions.');
    expect(warnedOf({ warnings: [] })).toBe('');
  });

  it('is shown on the map where it has a place', () => {
    const before = command.value;
    showMessage(message('danger', 'somewhere'));
    expect(command.value).toBe(before);

    showMessage(message('danger', 'here', { lon: -53, lat: 69 }));
    const wish = command.value;
    const places = wish?.do === 'fit' ? wish.places : [];
    expect(places.length).toBeGreaterThan(3);
    for (const [lon, lat] of places) expect(Math.hypot(lon + 53, lat - 69)).toBeLessThan(0.2);
  });
});
