import { lock } from '../model/login';
import type { Problem } from '../contract/types';

/** Thrown when the server refuses a request or cannot be reached; `problem` is its answer, or `silence`. */
export class ApiError extends Error {
  constructor(readonly problem: Problem) {
    super(problem.detail || problem.title);
  }
}

/** The name in a JSON pointer, without the parts that all pointers begin with. */
const placeOf = (pointer: string): string => pointer.replace(/^[/?](inputs\/|properties\/)?/, '');

/**
 * The faults that the server lists, each after the name of its place; if it lists none, one sentence about the failure.
 */
export function faultsOf(error: unknown, nameOf: (place: string) => string = (place) => place): string[] {
  if (!(error instanceof ApiError)) return [error instanceof Error ? error.message : String(error)];
  const listed = (error.problem.errors ?? []).map(({ pointer, detail }) => `${nameOf(placeOf(pointer))} ${detail}`.trim());
  return listed.length > 0 ? listed : [error.message];
}

/** The faults of `faultsOf` in one line. */
export const wordsOf = (error: unknown): string => faultsOf(error).join('; ');

/**
 * The dangers of a plan that the pilot has to confirm before the server returns files; empty if the request failed for
 * another reason.
 */
export const dangersIn = (error: unknown): string[] =>
  error instanceof ApiError && error.problem.type.endsWith('/dangerous-plan') ? (error.problem.errors ?? []).map(({ detail }) => detail) : [];

type Query = Record<string, string | number | boolean | undefined>;

/** The address of a request, relative to the page's origin, because the page only uses its own server. */
export function address(path: string, query: Query = {}): string {
  const search = new URLSearchParams();
  for (const [key, value] of Object.entries(query)) {
    if (value !== undefined) search.set(key, String(value));
  }
  const text = search.toString();
  return text ? `${path}?${text}` : path;
}

async function problemOf(response: Response): Promise<Problem> {
  const fallback: Problem = {
    type: 'about:blank',
    title: response.statusText || 'The server refused',
    status: response.status,
    detail: `The server answered ${response.status} to ${new URL(response.url).pathname}.`,
  };
  if (!(response.headers.get('content-type') ?? '').includes('json')) return fallback;
  try {
    const said = { ...fallback, ...((await response.json()) as Partial<Problem>) };
    const wait_s = response.headers.get('retry-after');
    return wait_s === null ? said : { ...said, detail: `${said.detail} Try again in ${wait_s} s.` };
  } catch {
    return fallback;
  }
}

/** The problem if the server does not answer. */
export const silence: Problem = { type: 'about:blank', title: 'No connection', status: 0, detail: 'The Floeplan server does not answer.' };

/** Status of every answer to a caller who needs a token and sent none. */
const unknown_caller = 401;

export function noteRefusal(status: number): void {
  if (status === unknown_caller) lock();
}

export async function request(path: string, init: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, init);
  } catch (error) {
    if (init.signal?.aborted) throw error;
    throw new ApiError(silence);
  }
  if (!response.ok) {
    noteRefusal(response.status);
    throw new ApiError(await problemOf(response));
  }
  return response;
}

export async function json<T>(path: string, init: RequestInit = {}): Promise<T> {
  const headers = { Accept: 'application/json, application/geo+json', ...(init.headers as Record<string, string> | undefined) };
  return (await (await request(path, { ...init, headers })).json()) as T;
}
