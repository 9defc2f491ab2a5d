import { createHash } from 'node:crypto';
import { describe, expect, it } from 'vitest';
import { Sha256 } from '../../src/model/sha256';

const digestOf = (pieces: Uint8Array[]): string => {
  const digest = new Sha256();
  for (const piece of pieces) digest.add(piece);
  return digest.digest();
};
const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);

describe('the digest of a file', () => {
  it('is that of the standard for its examples', () => {
    expect(digestOf([bytesOf('abc')])).toBe('ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad');
    expect(digestOf([])).toBe('e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855');
    expect(digestOf([bytesOf('abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq')])).toBe(
      '248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1',
    );
  });

  it('does not depend on the pieces it was taken in, at every length around a block', () => {
    const bytes = Uint8Array.from({ length: 300 }, (_, i) => (i * 7919) % 251);
    for (let length = 0; length <= bytes.length; ++length) {
      const whole = bytes.slice(0, length);
      const expected = createHash('sha256').update(whole).digest('hex');
      const cut = (length * 13) % (length + 1);
      expect(digestOf([whole])).toBe(expected);
      expect(digestOf([whole.subarray(0, cut), whole.subarray(cut)])).toBe(expected);
    }
  });
});
