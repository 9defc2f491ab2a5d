import { computed, signal } from '@preact/signals';
import { dialog, tell } from './screen';

export type Role = 'viewer' | 'pilot' | 'admin';

export interface Caller {
  name: string;
  role: Role;
  expires?: string; // of a login that was made in this page
}

/** The user as identified by the server; undefined until it has answered. */
export const caller = signal<Caller | undefined>(undefined);

/** Set while the server requires a token: at first, or because a login has ended. */
export const locked = signal<'first' | 'ended' | undefined>(undefined);

/** The server's name for all users while its store has no token. */
const everyone = 'local';

/** The user who signed in; undefined if no login is needed. */
export const signedIn = computed(() => (caller.value?.name === everyone ? undefined : caller.value));

/** Asks for a token, because the server has refused an unidentified caller. */
export function lock(): void {
  locked.value = caller.peek() ? 'ended' : 'first';
  dialog.value = 'login';
}

export function unlock(who: Caller): void {
  caller.value = who;
  locked.value = undefined;
}

const roles: readonly Role[] = ['viewer', 'pilot', 'admin'];

/** The permissions of a role, as shown in the login dialog. */
export const rights: Record<Role, string> = {
  viewer: 'look at everything and export missions',
  pilot: 'look, plan, simulate and add data',
  admin: 'everything, removing data included',
};

export function may(role: Role): boolean {
  const who = caller.value;
  return who === undefined || roles.indexOf(who.role) >= roles.indexOf(role);
}

/** Why the user may not do this; undefined if allowed. */
export function whyNot(role: Role, what: string): string | undefined {
  const who = caller.value;
  if (!who || may(role)) return undefined;
  return `${what} needs the role ${role}; you are signed in as ${who.name}, ${who.role}.`;
}

/** Whether an action is not allowed; if so, shows the reason. For actions started by keys and gestures. */
export function forbids(role: Role, what: string): boolean {
  const reason = whyNot(role, what);
  if (reason !== undefined) tell(reason);
  return reason !== undefined;
}
