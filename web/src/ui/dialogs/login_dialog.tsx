import type { VNode } from 'preact';
import { useState } from 'preact/hooks';
import { signIn, signOut } from '../../actions/login';
import { locked, rights, signedIn, type Caller } from '../../model/login';
import { dialog } from '../../model/screen';
import { shortTime } from '../../model/time';
import { Modal } from '../common/modal';

/** Sends the token to the server once; for a user who is signed in, shows the name and the logout button. */
export function LoginDialog(): VNode {
  const who = signedIn.value;
  if (who && !locked.value) return <Modal title="Signed in" guide="login"><Account who={who} /></Modal>;
  return <Modal title="Sign in" guide="login"><TokenForm /></Modal>;
}

function TokenForm(): VNode {
  const [token, setToken] = useState('');
  const [fault, setFault] = useState<string | undefined>(undefined);
  const [asking, setAsking] = useState(false);
  const submit = async (event: Event): Promise<void> => {
    event.preventDefault();
    if (token.trim() === '') {
      setFault('Type or paste your token.');
      return;
    }
    setAsking(true);
    const refusal = await signIn(token.trim());
    setAsking(false);
    setFault(refusal);
    if (refusal === undefined) dialog.value = undefined;
  };
  return (
    <form class="login" onSubmit={(event) => void submit(event)} noValidate>
      {locked.value === 'ended' && <p role="status">Your login has ended. What you typed is still here; sign in and go on.</p>}
      <p>This server answers those who show a token. Whoever runs it makes one with <code>floeplan token add NAME</code>.</p>
      <div class={fault ? 'field faulty' : 'field'}>
        <label for="login-token">Token</label>
        <div class="field-row">
          <input
            id="login-token" type="password" value={token} autocomplete="current-password" spellcheck={false} autofocus
            aria-invalid={fault ? true : undefined} aria-describedby={fault ? 'login-fault' : 'login-hint'}
            onInput={(event) => {
              setToken(event.currentTarget.value);
              setFault(undefined);
            }}
          />
          <button type="submit" class="primary" disabled={asking}>{asking ? 'Asking …' : 'Sign in'}</button>
        </div>
        {fault ? <p class="fault" id="login-fault" role="alert">{fault}</p> : <p class="hint" id="login-hint">It is shown to the server once and not kept in the page. The login lasts twelve hours.</p>}
      </div>
    </form>
  );
}

function Account({ who }: { who: Caller }): VNode {
  const [fault, setFault] = useState<string | undefined>(undefined);
  const leave = async (): Promise<void> => setFault(await signOut());
  return (
    <>
      <p><b>{who.name}</b>, role <b>{who.role}</b>: may {rights[who.role]}.</p>
      {who.expires && <p class="hint">The login ends {shortTime(Date.parse(who.expires))}.</p>}
      <button type="button" onClick={() => void leave()}>Sign out</button>
      {fault && <p class="fault" role="alert">{fault}</p>}
    </>
  );
}
