import { beginImport, changeFile, changeImport, distinct, forgetImport, importOf, isLive, uploadsOf, type Import, type SentFile } from '../model/imports';
import { announce } from '../model/screen';
import { Sha256 } from '../model/sha256';
import { takeStored } from '../model/datasets';
import * as api from './client';
import { follow } from './following';
import type { FileReport, IngestOptions, Upload } from '../contract/data_types';

/** Size of the pieces in which a file is read; small, so that the page stays responsive. */
const piece_bytes = 1 << 20;


const running = new Map<number, AbortController>();

/** The files of imports that may have to be sent again. */
const given = new Map<number, { files: File[]; options: IngestOptions }>();

/** Sends files that belong together and has the server ingest them; the state is in `imports`. */
export async function importFiles(files: File[], options: IngestOptions): Promise<void> {
  if (files.length === 0) return;
  const names = distinct(files.map(({ name }) => name));
  const { number } = beginImport(files.map(({ size }, i) => ({ name: names[i] ?? '', size })));
  announce(files.length === 1 ? `Sending ${names[0] ?? ''}.` : `Sending ${files.length} files.`);
  given.set(number, { files, options });
  await sendAndRead(number, []);
}

/** Whether a part of an import failed and can be sent again. */
export const maySendAgain = (one: Import): boolean =>
  given.has(one.number) && (one.state.stage === 'failed' || (one.state.stage === 'done' && one.files.some(({ stage }) => stage === 'failed')));

/**
 * Sends failed files again, for example after a login has expired, and has them ingested; files already ingested are
 * not repeated.
 */
export async function sendAgain(number: number): Promise<void> {
  const now = importOf(number);
  if (!now || !maySendAgain(now)) return;
  const reports = now.state.stage === 'done' ? now.state.reports : [];
  const files = now.files.map((file): SentFile => {
    if (file.stage !== 'failed') return reports.length > 0 ? { ...file, stage: 'read' } : file;
    return { name: file.name, size: file.size, stage: 'waiting', bytes: 0 };
  });
  changeImport(number, { files, state: { stage: 'sending' } });
  await sendAndRead(number, reports);
}

async function sendAndRead(number: number, reports: FileReport[]): Promise<void> {
  const { files, options } = given.get(number) ?? { files: [], options: {} };
  await carryOut(number, async (signal) => {
    const uploads: Upload[] = [];
    for (const [i, file] of files.entries()) {
      const known = importOf(number)?.files[i];
      if (!known || known.stage === 'read') continue;
      const upload = known.upload ?? (await send(number, i, file, known.name, signal));
      if (upload) uploads.push(upload);
    }
    if (uploads.length > 0) await read(number, uploads, options, signal, reports);
    else changeImport(number, { state: { stage: 'failed', detail: 'None of the files could be sent.' } });
  });
  const now = importOf(number);
  if (!now || !maySendAgain(now)) given.delete(number);
}

/** Has the server ingest refused files again with further options; they are still on the server. */
export async function readAgain(number: number, report: FileReport, options: IngestOptions): Promise<void> {
  const now = importOf(number);
  if (now?.state.stage !== 'done') return;
  const others = now.state.reports.filter((other) => other !== report);
  await carryOut(number, async (signal) => {
    await read(number, uploadsOf(report, now.files), options, signal, others);
  });
}

export function cancelImport(number: number): void {
  running.get(number)?.abort();
}

/** Removes an import from the list, and its unread upload from the server. */
export function dismissImport(number: number): void {
  const done = importOf(number);
  if (!done || isLive(done)) return;
  forgetImport(number);
  given.delete(number);
  removeUploads(done.files.flatMap(({ upload }) => upload ?? []));
}

async function carryOut(number: number, work: (signal: AbortSignal) => Promise<void>): Promise<void> {
  const controller = new AbortController();
  running.set(number, controller);
  try {
    await work(controller.signal);
  } catch (error) {
    changeImport(number, { state: controller.signal.aborted ? { stage: 'cancelled' } : { stage: 'failed', detail: api.wordsOf(error) } });
    announce(controller.signal.aborted ? 'The import was cancelled.' : `The import failed: ${api.wordsOf(error)}`);
  } finally {
    running.delete(number);
  }
}

/**
 * Sends one file: computes its digest, then sends its bytes. Undefined if it failed; its row then shows the failure.
 */
async function send(number: number, index: number, file: File, name: string, signal: AbortSignal): Promise<Upload | undefined> {
  const tell = (part: Parameters<typeof changeFile>[2]): void => changeFile(number, index, part);
  try {
    tell({ stage: 'checking' });
    const sha256 = await digestOf(file, signal, (bytes) => tell({ bytes }));
    tell({ stage: 'sending', bytes: 0 });
    const upload = await api.sendFile(file, name, sha256, signal, (bytes) => tell({ bytes: Math.min(bytes, file.size) }));
    tell({ stage: 'sent', bytes: file.size, upload });
    return upload;
  } catch (error) {
    if (signal.aborted) throw error;
    tell({ stage: 'failed', fault: faultOf(error) });
    return undefined;
  }
}

function faultOf(error: unknown): string {
  if (error instanceof api.ApiError) return error.problem.errors?.map(({ detail }) => detail).join('; ') ?? error.message;
  if (error instanceof DOMException) return 'It cannot be read; it may be a folder, or have changed since it was chosen.';
  return api.wordsOf(error);
}

async function digestOf(file: File, signal: AbortSignal, tell: (bytes: number) => void): Promise<string> {
  const digest = new Sha256();
  for (let from = 0; from < file.size; from += piece_bytes) {
    signal.throwIfAborted();
    const piece = new Uint8Array(await file.slice(from, from + piece_bytes).arrayBuffer());
    digest.add(piece);
    tell(from + piece.length);
  }
  return digest.digest();
}

async function read(number: number, uploads: Upload[], options: IngestOptions, signal: AbortSignal, others: FileReport[] = []): Promise<void> {
  changeImport(number, { state: { stage: 'reading', job: undefined } });
  const begun = await api.submitIngest({ ...options, uploads: uploads.map(({ id }) => id) });
  const job = await follow(begun, signal, (now) => changeImport(number, { state: { stage: 'reading', job: now } }));
  if (job.status === 'dismissed') {
    changeImport(number, { state: { stage: 'cancelled' } });
    announce('The import was cancelled.');
    return;
  }
  if (job.status === 'failed') throw new Error(job.message || 'The server gave no reason.');
  const { report } = await api.ingestReport(job.jobID);
  const reports = report.datasets;
  changeImport(number, { state: { stage: 'done', reports: [...others, ...reports] } });
  announce(spoken(reports));
  settleUploads(number, reports);
  if (reports.some(({ status }) => status === 'stored')) takeStored(await api.datasets());
}

/** Removes uploads of ingested files from the server; refused files stay for another attempt. */
function settleUploads(number: number, reports: FileReport[]): void {
  const files = importOf(number)?.files ?? [];
  const refused = new Set(reports.filter(({ status }) => status === 'refused').flatMap((report) => uploadsOf(report, files)));
  const settled = reports.flatMap((report) => uploadsOf(report, files)).filter((upload) => !refused.has(upload));
  removeUploads([...new Set(settled)]);
}

/** Removes uploads. If that fails, they expire on the server. */
function removeUploads(uploads: Upload[]): void {
  for (const { id } of uploads) void api.deleteUpload(id).catch(() => undefined);
}

function spoken(reports: FileReport[]): string {
  const count = (status: FileReport['status']): number => reports.filter((report) => report.status === status).length;
  const parts = [
    [count('stored'), 'stored'], [count('unchanged'), 'known already'], [count('refused'), 'refused'],
  ].filter(([number]) => number !== 0);
  return `Import finished: ${parts.map(([number, word]) => `${number ?? 0} ${word ?? ''}`).join(', ')}.`;
}
