import { computed, signal } from '@preact/signals';
import { dialog, tell } from './screen';

export type Role = 'viewer' | 'pilot' | 'admin';

export interface Caller {
  name: string;
  role: Role;
  expires?: string; // of a login that was made in this page
}

/** Who the server takes the person for; undefined as long as it has not said so. */
export const caller = signal<Caller | undefined>(undefined);

/** Set while the server answers nobody without a token: at first, or because a login has ended. */
export const locked = signal<'first' | 'ended' | undefined>(undefined);

/** What the server calls everyone as long as its store holds no token. */
const everyone = 'local';

/** The one who signed in; undefined also where nobody has to. */
export const signedIn = computed(() => (caller.value?.name === everyone ? undefined : caller.value));

/** The server has answered that it knows nobody who asks: they are asked for their token. */
export function lock(): void {
  locked.value = caller.peek() ? 'ended' : 'first';
  dialog.value = 'login';
}

export function unlock(who: Caller): void {
  caller.value = who;
  locked.value = undefined;
}

const roles: readonly Role[] = ['viewer', 'pilot', 'admin'];

/** What a role may, in the words of the login dialog. */
export const rights: Record<Role, string> = {
  viewer: 'look at everything and export missions',
  pilot: 'look, plan, simulate and add data',
  admin: 'everything, removing data included',
};

export function may(role: Role): boolean {
  const who = caller.value;
  return who === undefined || roles.indexOf(who.role) >= roles.indexOf(role);
}

/** Why something is not for this person, told before it is tried; undefined where it is. */
export function whyNot(role: Role, what: string): string | undefined {
  const who = caller.value;
  if (!who || may(role)) return undefined;
  return `${what} needs the role ${role}; you are signed in as ${who.name}, ${who.role}.`;
}

/** Whether an action is refused here, and then says so: for what keys and gestures begin. */
export function forbids(role: Role, what: string): boolean {
  const reason = whyNot(role, what);
  if (reason !== undefined) tell(reason);
  return reason !== undefined;
}
