import type { VNode } from 'preact';
import { whyNot, type Role } from '../../model/login';
import { Icon } from './icon';

/** Says beside what is asked for that it is not for the one who is signed in; nothing where it is. */
export function RoleNote({ role, what, id }: { role: Role; what: string; id?: string }): VNode | null {
  const reason = whyNot(role, what);
  return reason === undefined ? null : <p class="role-note" id={id}><Icon name="lock" size={13} /><span>{reason}</span></p>;
}
