import { render } from 'preact';
import { followRouteEdit } from './api/evaluating';
import { followFields } from './api/fields';
import { followSpans, refresh } from './api/session';
import { keepDraft } from './model/stored_draft';
import { followTheme } from './theme/theme';
import { App } from './ui/app';
import { listenForShortcuts } from './ui/shortcuts';

keepDraft();
followTheme();
followSpans();
const root = document.getElementById('app');
if (root) render(<App />, root);
followFields();
followRouteEdit();
listenForShortcuts();
void refresh();
