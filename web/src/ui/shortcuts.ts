import { editCopy } from '../actions/plan_inputs';
import { plan } from '../actions/planning';
import { probeAt } from '../actions/probing';
import { range, setTime, stepHours, togglePlay } from '../model/clock';
import { openBergId } from '../model/ice/berg_card';
import { drawByKey } from '../model/drawing';
import { forbids } from '../model/login';
import { routeOf, select, selectedPlan, selectedWaypoint, shownPlans } from '../model/plan/plans';
import { openEdit } from '../model/plan/route_edit';
import { dialog, drawer, leftTab } from '../model/screen';
import { settings } from '../model/settings';
import { ask, tool, view, type Tool } from '../model/view';
import { redoAndTell, undoAndTell } from './common/undo_buttons';
import { editByKey } from './edit_keys';
import { placeByKey } from './placing_keys';

const focus = (selector: string): void => document.querySelector<HTMLElement>(selector)?.focus();

function pick(next: Tool): void {
  tool.value = next;
  focus('#map');
}

const actions: Record<string, () => void> = {
  ' ': togglePlay,
  ',': () => stepHours(-1),
  '.': () => stepHours(1),
  '[': () => stepHours(-6),
  ']': () => stepHours(6),
  Home: () => setTime(range.peek().start_ms),
  End: () => setTime(range.peek().end_ms),
  p: () => void plan(),
  s: () => pick('from'),
  e: () => pick('to'),
  n: () => ask({ do: 'north' }),
  '+': () => ask({ do: 'zoom', by: 1 }),
  '-': () => ask({ do: 'zoom', by: -1 }),
  f: () => {
    const chosen = selectedPlan.peek();
    if (chosen) ask({ do: 'fit', places: routeOf(chosen) });
  },
  g: () => {
    leftTab.value = 'setup';
    queueMicrotask(() => focus('#field-from'));
  },
  d: () => {
    const chosen = selectedPlan.peek();
    if (!chosen || openEdit.peek() || forbids('pilot', 'Changing a plan')) return;
    void editCopy(chosen);
  },
  i: () => {
    const seen = view.peek();
    if (seen) void probeAt(seen.centre);
  },
  l: () => focus('.layers summary'),
  '?': () => {
    dialog.value = 'help';
  },
};

const takesText = 'input:not([type=range]):not([type=checkbox]):not([type=radio]), textarea, select';
const takesSpace = 'button, a, summary, input[type=checkbox], input[type=radio]';

/** Text fields whose value is used only when it is complete: until then the browser's own undo of letters is used. */
const undoesLetters = 'textarea, input:not([type=range]):not([type=checkbox]):not([type=radio])';
const takesLetters = 'form.setup input';

/** Handles undo (Ctrl+Z) and redo (Ctrl+Shift+Z, Ctrl+Y); true if the key was one of them. */
function undoByKey(event: KeyboardEvent, target: Element | undefined): boolean {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
  if (target?.matches(undoesLetters) && !target.matches(takesLetters)) return false;
  const key = event.key.toLowerCase();
  if (key === 'y' || (key === 'z' && event.shiftKey)) redoAndTell();
  else if (key === 'z') undoAndTell();
  else return false;
  return true;
}

/** Handles single-key shortcuts, unless a text field or dialog has the focus or the user has switched them off. */
export function listenForShortcuts(): void {
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && dialog.peek() === undefined) {
      if (tool.peek() === 'safe') dialog.value = 'export'; // the dialog from which the tool was chosen
      tool.value = 'pan';
      selectedWaypoint.value = undefined;
      openBergId.value = undefined;
      drawer.value = undefined;
      return;
    }
    const target = event.target instanceof Element ? event.target : undefined;
    if (dialog.peek() === undefined && placeByKey(event)) {
      event.preventDefault();
      return;
    }
    if (dialog.peek() === undefined && !target?.closest(`${takesText}, ${takesSpace}`) && drawByKey(event.key)) {
      event.preventDefault();
      return;
    }
    if (dialog.peek() === undefined && undoByKey(event, target)) {
      event.preventDefault();
      return;
    }
    if (dialog.peek() === undefined && editByKey(event)) {
      event.preventDefault();
      return;
    }
    if (event.ctrlKey || event.altKey || event.metaKey || dialog.peek() || target?.closest(takesText)) return;
    if (!settings.peek().shortcuts) return;
    if (event.key === ' ' && target?.closest(takesSpace)) return;

    const shown = /^[1-9]$/.test(event.key) ? shownPlans.peek()[Number(event.key) - 1] : undefined;
    if (shown) select(shown.plan.plan_id);
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
