import type { VNode } from 'preact';
import { announcement, dialog, drawer, leftTab, notice, rightTab } from '../model/screen';
import { guidePages } from '../model/guide_pages';
import { plans } from '../model/plan/plans';
import { ClockBar } from './clock/clock_bar';
import { GuideLink } from './common/guide_link';
import { dialogLater, later } from './common/later';
import { DropOverlay } from './data/drop_overlay';
import { Header } from './header/header';
import { LayersPanel } from './layers/layers_panel';
import { MapPanel } from './map/map_panel';
import { PlansPanel } from './plans/plans_panel';
import { SetupPanel } from './setup/setup_panel';
import { WaypointsPanel } from './waypoints/waypoints_panel';

const DataPanel = later(async () => (await import('./data/data_panel')).DataPanel);
const LoginDialog = dialogLater(async () => (await import('./dialogs/login_dialog')).LoginDialog);
const HelpDialog = dialogLater(async () => (await import('./dialogs/help_dialog')).HelpDialog);
const JobsDialog = dialogLater(async () => (await import('./dialogs/jobs_dialog')).JobsDialog);
const ExportDialog = dialogLater(async () => (await import('./export/export_dialog')).ExportDialog);
const CompareDialog = dialogLater(async () => (await import('./plans/compare_dialog')).CompareDialog);

/** The screen: on the left the set-up, on the right the results, the clock below, the map between them. */
export function App(): VNode {
  return (
    <div class="app" data-drawer={drawer.value}>
      <nav aria-label="Skip">
        <a class="skip-link" href="#map">To the map</a>
        <a class="skip-link" href="#left">To set-up and plans</a>
        <a class="skip-link" href="#right">To the waypoints</a>
      </nav>
      <Header />
      <aside class="left" id="left" aria-label="Set-up, plans, data and layers" tabIndex={-1}>
        <div class="left-scroll">
          <Tabs />
          {leftTab.value === 'setup' ? <SetupPanel /> : leftTab.value === 'plans' ? <PlansPanel /> : <DataPanel />}
        </div>
        <LayersPanel />
        <p class="disclaimer"><span>Not for navigation; check before flight.</span> <GuideLink page={guidePages[leftTab.value]} /></p>
      </aside>
      <MapPanel />
      <aside class="right" id="right" aria-label="Waypoints" tabIndex={-1}>
        <WaypointsPanel />
        <p class="disclaimer"><GuideLink page={guidePages[rightTab.value]} /></p>
      </aside>
      <ClockBar />
      {dialog.value === 'export' && <ExportDialog />}
      {dialog.value === 'compare' && <CompareDialog />}
      {dialog.value === 'help' && <HelpDialog />}
      {dialog.value === 'jobs' && <JobsDialog />}
      {dialog.value === 'login' && <LoginDialog />}
      <DropOverlay />
      {notice.value && <p class="notice" aria-hidden="true">{notice.value}</p>}
      <div class="visually-hidden" aria-live="polite">{announcement.value}</div>
    </div>
  );
}

function Tabs(): VNode {
  const tabs = [['setup', 'Set-up'], ['plans', `Plans${plans.value.length > 0 ? ` (${plans.value.length})` : ''}`], ['data', 'Data']] as const;
  return (
    <div class="tabs" role="group" aria-label="Left panel">
      {tabs.map(([name, title]) => (
        <button type="button" key={name} aria-pressed={leftTab.value === name} onClick={() => { leftTab.value = name; }}>{title}</button>
      ))}
    </div>
  );
}
