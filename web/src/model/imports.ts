import { computed, signal } from '@preact/signals';
import type { FileReport, Upload } from '../contract/data_types';
import type { JobStatus } from '../contract/types';

/** A file on its way into the store. */
export interface SentFile {
  name: string;
  size: number;
  stage: 'waiting' | 'checking' | 'sending' | 'sent' | 'read' | 'failed';
  bytes: number; // of the stage that are done
  upload?: Upload;
  fault?: string;
}

/** Files that were given together and are read together: a dataset may lie in several. */
export interface Import {
  number: number;
  files: SentFile[];
  state:
    | { stage: 'sending' }
    | { stage: 'reading'; job: JobStatus | undefined }
    | { stage: 'done'; reports: FileReport[] }
    | { stage: 'failed'; detail: string }
    | { stage: 'cancelled' };
}

/** Newest first. */
export const imports = signal<Import[]>([]);

let last = 0;

export function beginImport(files: { name: string; size: number }[]): Import {
  const begun: Import = {
    number: ++last,
    files: files.map(({ name, size }) => ({ name, size, stage: 'waiting', bytes: 0 })),
    state: { stage: 'sending' },
  };
  imports.value = [begun, ...imports.peek()];
  return begun;
}

export function changeImport(number: number, part: Partial<Omit<Import, 'number'>>): void {
  imports.value = imports.peek().map((one) => (one.number === number ? { ...one, ...part } : one));
}

export function changeFile(number: number, index: number, part: Partial<SentFile>): void {
  const files = importOf(number)?.files.map((file, i) => (i === index ? { ...file, ...part } : file));
  if (files) changeImport(number, { files });
}

export const importOf = (number: number): Import | undefined => imports.peek().find((one) => one.number === number);

export function forgetImport(number: number): void {
  imports.value = imports.peek().filter((one) => one.number !== number);
}

export const isLive = ({ state }: Import): boolean => state.stage === 'sending' || state.stage === 'reading';
export const importing = computed(() => imports.value.some(isLive));

/** Uploads of the files that a report speaks of: it names those that were read together, joined by " + ". */
export function uploadsOf(report: FileReport, files: SentFile[]): Upload[] {
  const names = report.file.split(' + ');
  return files.flatMap(({ upload }) => (upload && names.includes(upload.name) ? [upload] : []));
}

/** Names that differ from each other, as the server's reader tells files apart by them. */
export function distinct(names: string[]): string[] {
  const used = new Set<string>();
  return names.map((name) => {
    let free = name;
    for (let i = 2; used.has(free); ++i) free = `${i}-${name}`;
    used.add(free);
    return free;
  });
}
