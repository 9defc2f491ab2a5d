import type { VNode } from 'preact';
import { whyNot, type Role } from '../../model/login';
import { Icon } from './icon';

/** A note beside a control that the signed-in role may not use. Empty if the role may use it. */
export function RoleNote({ role, what, id }: { role: Role; what: string; id?: string }): VNode | null {
  const reason = whyNot(role, what);
  return reason === undefined ? null : <p class="role-note" id={id}><Icon name="lock" size={13} /><span>{reason}</span></p>;
}
