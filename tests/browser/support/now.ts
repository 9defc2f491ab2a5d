import type { BrowserContext } from '@playwright/test';

/**
 * Every journey begins at the same instant, half a day into the demonstration currents. By the clock of the machine the
 * departures that the page proposes would move from hour to hour, and one day past the end of the data.
 */
const ahead_ms = Date.parse('2026-11-22T12:00:00Z') - Date.now();

export const now = (): number => Date.now() + ahead_ms;

/** Lets the pages believe that it is that instant; time goes by as it does. */
export async function setClock(pages: BrowserContext): Promise<void> {
  await pages.addInitScript((ahead) => {
    globalThis.Date = new Proxy(Date, {
      construct: (real, parts: unknown[]) => (parts.length === 0 ? new real(real.now() + ahead) : (Reflect.construct(real, parts) as Date)),
      get: (real, name) => (name === 'now' ? () => real.now() + ahead : (Reflect.get(real, name) as unknown)),
    });
  }, ahead_ms);
}
