/** A made-up current field over a box as a NetCDF classic file (64-bit offsets are not needed): hourly, one depth, CF names. */
export function currentFile(box: [west: number, south: number, east: number, north: number], step_deg: number, start: Date, hours: number): Buffer {
  const axis = (from: number, to: number): number[] => Array.from({ length: Math.round((to - from) / step_deg) + 1 }, (_, i) => from + i * step_deg);
  const [lon, lat] = [axis(box[0], box[2]), axis(box[1], box[3])];
  const time = Array.from({ length: hours }, (_, i) => i);
  const dims = [['time', hours], ['latitude', lat.length], ['longitude', lon.length]] as const;
  const since = `hours since ${start.toISOString().slice(0, 19).replace('T', ' ')}`;
  const variables: { name: string; dims: number[]; texts: Record<string, string>; values: () => Iterable<number>; count: number }[] = [
    { name: 'time', dims: [0], texts: { units: since, standard_name: 'time' }, values: () => time, count: hours },
    { name: 'latitude', dims: [1], texts: { units: 'degrees_north', standard_name: 'latitude' }, values: () => lat, count: lat.length },
    { name: 'longitude', dims: [2], texts: { units: 'degrees_east', standard_name: 'longitude' }, values: () => lon, count: lon.length },
    ...(['eastward', 'northward'] as const).map((towards, k) => ({
      name: k === 0 ? 'uo' : 'vo', dims: [0, 1, 2], texts: { units: 'm s-1', standard_name: `${towards}_sea_water_velocity` },
      * values(): Iterable<number> {
        for (const t of time) for (const y of lat) for (const x of lon) yield 0.1 * Math.sin(0.5 * t + (k === 0 ? 3 * y : 2 * x)) + 0.05 * Math.cos(x * y);
      },
      count: hours * lat.length * lon.length,
    })),
  ];

  const head = (begins: number[]): Buffer => {
    const parts: Buffer[] = [];
    const int = (value: number): void => {
      const bytes = Buffer.alloc(4);
      bytes.writeInt32BE(value);
      parts.push(bytes);
    };
    const text = (value: string): void => {
      int(value.length);
      parts.push(Buffer.from(value), Buffer.alloc((4 - (value.length % 4)) % 4));
    };
    const [dimensionTag, variableTag, attributeTag, charType, floatType] = [10, 11, 12, 2, 5];
    parts.push(Buffer.from('CDF\x01'));
    int(0); // no records
    int(dimensionTag);
    int(dims.length);
    for (const [name, length] of dims) {
      text(name);
      int(length);
    }
    int(0); // no attributes of the whole
    int(0);
    int(variableTag);
    int(variables.length);
    variables.forEach(({ name, dims: its, texts, count }, i) => {
      text(name);
      int(its.length);
      its.forEach(int);
      int(attributeTag);
      int(Object.keys(texts).length);
      for (const [key, value] of Object.entries(texts)) {
        text(key);
        int(charType);
        text(value);
      }
      int(floatType);
      int(4 * count);
      int(begins[i] ?? 0);
    });
    return Buffer.concat(parts);
  };
  const length = head([]).length;
  let at = length;
  const begins = variables.map(({ count }) => {
    const begin = at;
    at += 4 * count;
    return begin;
  });
  const file = Buffer.alloc(at);
  head(begins).copy(file);
  variables.forEach(({ values }, i) => {
    let offset = begins[i] ?? 0;
    for (const value of values()) offset = file.writeFloatBE(value, offset);
  });
  return file;
}
