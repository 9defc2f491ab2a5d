/** Instants are milliseconds since 1970 in UTC; nothing here knows a local time zone. */

export const minute_ms = 60_000;
export const hour_ms = 60 * minute_ms;
export const day_ms = 24 * hour_ms;
const half_a_year_ms = 183 * day_ms;

const months = ['Jan', 'Feb', 'Mar', 'Apr', 'May', 'Jun', 'Jul', 'Aug', 'Sep', 'Oct', 'Nov', 'Dec'];
const fullMonths = [
  'January', 'February', 'March', 'April', 'May', 'June', 'July', 'August', 'September', 'October', 'November', 'December',
];
const two = (value: number): string => String(value).padStart(2, '0');

/** 2026-11-20T06:00:00Z */
export function isoOf(time_ms: number): string {
  return new Date(time_ms).toISOString().replace(/\.\d+Z$/, 'Z');
}

/** "2026-11-20 06:00", what a person types and sees in fields; always UTC. */
export function fieldOf(time_ms: number): string {
  return isoOf(time_ms).slice(0, 16).replace('T', ' ');
}

/** "20 Nov 06:00Z", and "20 Nov 2019 06:00Z" where a reader of today could take it for another year's. */
export function shortTime(time_ms: number, now_ms: number = Date.now()): string {
  const date = new Date(time_ms);
  const year = Math.abs(time_ms - now_ms) > half_a_year_ms ? ` ${date.getUTCFullYear()}` : '';
  return `${date.getUTCDate()} ${months[date.getUTCMonth()] ?? ''}${year} ${two(date.getUTCHours())}:${two(date.getUTCMinutes())}Z`;
}

/** "20 November 06:00 UTC", for screen readers. */
export function spokenTime(time_ms: number): string {
  const date = new Date(time_ms);
  return `${date.getUTCDate()} ${fullMonths[date.getUTCMonth()] ?? ''} ${two(date.getUTCHours())}:${two(date.getUTCMinutes())} UTC`;
}

/** Reads "2026-11-20 06:00", "2026-11-20T06:00:00Z", "2026-11-20" or "2026-11-20 06"; all are UTC. */
export function parseTime(text: string): number | undefined {
  const match = /^\s*(\d{4})-(\d{2})-(\d{2})(?:[T ]+(\d{1,2})(?::?(\d{2}))?(?::(\d{2}))?)?\s*(?:Z|UTC)?\s*$/i.exec(text);
  if (!match) return undefined;
  const [year, month, day, hours, minutes, seconds] = match.slice(1).map((part) => Number(part || 0));
  if (year === undefined || month === undefined || day === undefined) return undefined;
  if ((hours ?? 0) > 23 || (minutes ?? 0) > 59 || (seconds ?? 0) > 59) return undefined;
  const time_ms = Date.UTC(year, month - 1, day, hours, minutes, seconds);
  const date = new Date(time_ms);
  return date.getUTCMonth() === month - 1 && date.getUTCDate() === day ? time_ms : undefined;
}

/** "3 d 04 h", "5 h 20 min", "12 min" */
export function duration(seconds: number): string {
  const minutes = Math.round(seconds / 60);
  if (minutes < 60) return `${minutes} min`;
  const hours = Math.floor(minutes / 60);
  if (hours < 24) return `${hours} h ${two(minutes % 60)} min`;
  const whole = Math.round(minutes / 60);
  return `${Math.floor(whole / 24)} d ${two(whole % 24)} h`;
}

/** How long ago, roughly: "just now", "4 h old", "3 d old". */
export function age(seconds: number): string {
  if (seconds < 3600) return 'under 1 h old';
  if (seconds < 48 * 3600) return `${Math.floor(seconds / 3600)} h old`;
  return `${Math.floor(seconds / 86_400)} d old`;
}
