import type { VNode } from 'preact';
import type { Message, Told } from '../../contract/types';
import { formatPosition } from '../../geo/coordinates';
import { countOf, messagesOf, placeOf, showMessage, type Rank } from '../../model/messages';
import { asSentence } from '../../model/page_words';
import { dialog } from '../../model/screen';
import { settings } from '../../model/settings';
import { Icon } from './icon';

/**
 * Messages to the pilot by rank: dangers, then cautions, then notes, which are folded at first. `about`: in the names of
 * their regions, if they are not those of the selected plan.
 */
export function Messages({ of, about = '' }: { of: Told; about?: string }): VNode {
  const told = messagesOf(of);
  const ranked = (rank: Rank): Message[] => told.filter((message) => message.rank === rank);
  const notes = ranked('note');
  return (
    <>
      <Box messages={ranked('danger')} rank="danger" about={about} />
      <Box messages={ranked('caution')} rank="caution" about={about} />
      {notes.length > 0 && (
        <details class="note-box">
          <summary>{countOf(notes.length, 'note')}</summary>
          <MessageList messages={notes} />
        </details>
      )}
    </>
  );
}

function Box({ messages, rank, about }: { messages: Message[]; rank: 'danger' | 'caution'; about: string }): VNode | null {
  if (messages.length === 0) return null;
  return (
    <section class={`${rank}-box`} aria-label={`${rank === 'danger' ? 'Dangers' : 'Cautions'}${about}`}>
      <h3><Icon name="warning" /> {countOf(messages.length, rank)}</h3>
      <MessageList messages={messages} />
    </section>
  );
}

/** Shows the place of a message on the map, and closes the dialog, which would hide it. */
function show(message: Message): void {
  dialog.value = undefined;
  showMessage(message);
}

/** The messages of a rank; one with a place has a button that moves the map there. */
export function MessageList({ messages }: { messages: Message[] }): VNode {
  return (
    <ul class="messages">
      {messages.map((message) => {
        const place = placeOf(message);
        return (
          <li key={`${message.code} ${message.text}`}>
            {asSentence(message.text)}
            {place && (
              <button type="button" class="link place" title="Show on the map" onClick={() => show(message)}>
                {formatPosition(place, settings.value.coordinates)}
              </button>
            )}
          </li>
        );
      })}
    </ul>
  );
}
