/** The parts of proj4 that the client bundles: the core, without its table of forty projections. */
declare module 'proj4/lib/core' {
  interface Converter {
    forward(coordinate: number[]): number[];
    inverse(coordinate: number[]): number[];
  }
  function proj4(from: string, to: string): Converter;
  export default proj4;
}
declare module 'proj4/lib/Proj' {
  const Proj: { projections: { add(projection: unknown): void } };
  export default Proj;
}
declare module 'proj4/lib/defs' {
  function defs(name: string, definition: string): void;
  export default defs;
}
declare module 'proj4/lib/projections/stere' {
  const stere: unknown;
  export default stere;
}
