/** Remembers for what view and features a layer was drawn last. Compared as numbers: made in every frame for every layer, texts would be costly. */
export class LastDrawn {
  private numbers: readonly number[] = [];

  /** Whether it was drawn for the same numbers before; otherwise they count as drawn from now on. */
  isFor(...numbers: number[]): boolean {
    const isSame = numbers.length === this.numbers.length && numbers.every((value, i) => value === this.numbers[i]);
    if (!isSame) this.numbers = numbers;
    return isSame;
  }
}
