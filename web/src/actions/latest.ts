import { ApiError } from './client';
import { loading } from '../model/field';

/**
 * Keeps only the newest of several loads of the same thing: a newer load aborts the older, and a late answer of an
 * older load is ignored. A load begins in a task of its own, so that no frame of a playing clock waits for it; of those
 * begun until then only the newest is sent.
 */
export class Latest {
  private controller: AbortController | undefined;

  run<T>(load: (signal: AbortSignal) => Promise<T>, deliver: (value: T) => void, refuse: (fault: string) => void): void {
    this.cancel();
    const controller = new AbortController();
    this.controller = controller;
    loading.value += 1;
    new Promise((begin) => setTimeout(begin))
      .then(() => {
        controller.signal.throwIfAborted();
        return load(controller.signal);
      })
      .then((value) => {
        if (!controller.signal.aborted) deliver(value);
      })
      .catch((error: unknown) => {
        if (!controller.signal.aborted) refuse(error instanceof ApiError ? error.message : String(error));
      })
      .finally(() => {
        loading.value -= 1;
      });
  }

  cancel(): void {
    this.controller?.abort();
    this.controller = undefined;
  }
}
