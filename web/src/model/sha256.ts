/**
 * The digest of a file that is read in pieces, so that it is never in memory as a whole. Source  FIPS 180-4, section
 * 6.2.
 */

const primes = ((): number[] => {
  const found: number[] = [];
  for (let n = 2; found.length < 64; ++n) if (found.every((prime) => n % prime !== 0)) found.push(n);
  return found;
})();

/** The first 32 bits of the fraction of a root, as the standard defines its constants. */
const fraction = (root: number): number => Math.floor((root % 1) * 2 ** 32) | 0;
const rounds = Int32Array.from(primes, (prime) => fraction(Math.cbrt(prime)));
const start = Int32Array.from(primes.slice(0, 8), (prime) => fraction(Math.sqrt(prime)));

const block_bytes = 64;
const at = (words: Int32Array, i: number): number => words[i] ?? 0;
const turned = (word: number, bits: number): number => (word >>> bits) | (word << (32 - bits));

export class Sha256 {
  private readonly state = Int32Array.from(start);
  private readonly words = new Int32Array(64);
  private readonly rest = new Uint8Array(block_bytes);
  private restLength = 0;
  private length = 0;

  add(bytes: Uint8Array): void {
    this.length += bytes.length;
    let from = 0;
    if (this.restLength > 0) {
      from = Math.min(block_bytes - this.restLength, bytes.length);
      this.rest.set(bytes.subarray(0, from), this.restLength);
      this.restLength += from;
      if (this.restLength < block_bytes) return;
      this.mix(new DataView(this.rest.buffer), 0);
    }
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    for (; from + block_bytes <= bytes.length; from += block_bytes) this.mix(view, from);
    this.rest.set(bytes.subarray(from));
    this.restLength = bytes.length - from;
  }

  /** 64 hexadecimal digits; nothing can be added afterwards. */
  digest(): string {
    const bits = 8 * this.length;
    const zeros = (((block_bytes - 9 - this.restLength) % block_bytes) + block_bytes) % block_bytes;
    const end = new Uint8Array(1 + zeros + 8);
    end[0] = 0x80;
    const view = new DataView(end.buffer);
    view.setUint32(1 + zeros, Math.floor(bits / 2 ** 32));
    view.setUint32(5 + zeros, bits >>> 0);
    this.add(end);
    return Array.from(this.state, (word) => (word >>> 0).toString(16).padStart(8, '0')).join('');
  }

  private mix(view: DataView, from: number): void {
    const w = this.words;
    for (let i = 0; i < 16; ++i) w[i] = view.getInt32(from + 4 * i);
    for (let i = 16; i < 64; ++i) {
      const [older, newer] = [at(w, i - 15), at(w, i - 2)];
      const s0 = turned(older, 7) ^ turned(older, 18) ^ (older >>> 3);
      const s1 = turned(newer, 17) ^ turned(newer, 19) ^ (newer >>> 10);
      w[i] = (at(w, i - 16) + s0 + at(w, i - 7) + s1) | 0;
    }
    const s = this.state;
    let [a, b, c, d] = [at(s, 0), at(s, 1), at(s, 2), at(s, 3)];
    let [e, f, g, h] = [at(s, 4), at(s, 5), at(s, 6), at(s, 7)];
    for (let i = 0; i < 64; ++i) {
      const s1 = turned(e, 6) ^ turned(e, 11) ^ turned(e, 25);
      const t1 = (h + s1 + ((e & f) ^ (~e & g)) + at(rounds, i) + at(w, i)) | 0;
      const s0 = turned(a, 2) ^ turned(a, 13) ^ turned(a, 22);
      const t2 = (s0 + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      h = g;
      g = f;
      f = e;
      e = (d + t1) | 0;
      d = c;
      c = b;
      b = a;
      a = (t1 + t2) | 0;
    }
    for (const [i, word] of [a, b, c, d, e, f, g, h].entries()) s[i] = at(s, i) + word;
  }
}
