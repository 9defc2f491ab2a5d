import { computed, signal } from '@preact/signals';
import type { FileReport, Upload } from '../contract/data_types';
import type { JobStatus } from '../contract/types';

/** A file being imported. */
export interface SentFile {
  name: string;
  size: number;
  stage: 'waiting' | 'checking' | 'sending' | 'sent' | 'read' | 'failed';
  bytes: number; // the part of the file that the present stage has done
  upload?: Upload;
  fault?: string;
}

/** Files that were chosen together and are ingested together, because a dataset may be spread over several. */
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

/** The uploads of the files that a report is about: it names files that were ingested together, joined by " + ". */
export function uploadsOf(report: FileReport, files: SentFile[]): Upload[] {
  const names = report.file.split(' + ');
  return files.flatMap(({ upload }) => (upload && names.includes(upload.name) ? [upload] : []));
}

/** Different names for the files, because the server distinguishes files by their names. */
export function distinct(names: string[]): string[] {
  const used = new Set<string>();
  return names.map((name) => {
    let free = name;
    for (let i = 2; used.has(free); ++i) free = `${i}-${name}`;
    used.add(free);
    return free;
  });
}
