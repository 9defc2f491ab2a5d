import type { VNode } from 'preact';
import { announcement, dialog, drawer, leftTab, notice } from '../model/screen';
import { plans } from '../model/plans';
import { ClockBar } from './clock/clock_bar';
import { DataPanel } from './data/data_panel';
import { DropOverlay } from './data/drop_overlay';
import { HelpDialog } from './dialogs/help_dialog';
import { JobsDialog } from './dialogs/jobs_dialog';
import { LoginDialog } from './dialogs/login_dialog';
import { ExportDialog } from './export/export_dialog';
import { Header } from './header/header';
import { LayersPanel } from './layers/layers_panel';
import { MapPanel } from './map/map_panel';
import { CompareDialog } from './plans/compare_dialog';
import { PlansPanel } from './plans/plans_panel';
import { SetupPanel } from './setup/setup_panel';
import { WaypointsPanel } from './waypoints/waypoints_panel';

/** The screen: left what is asked, right what was got, below one clock, the map between. */
export function App(): VNode {
  return (
    <div class="app" data-drawer={drawer.value}>
      <nav class="skip-links" aria-label="Skip">
        <a href="#map">To the map</a>
        <a href="#left">To set-up and plans</a>
        <a href="#right">To the waypoints</a>
      </nav>
      <Header />
      <aside class="left" id="left" aria-label="Set-up, plans, data and layers" tabIndex={-1}>
        <div class="left-scroll">
          <Tabs />
          {leftTab.value === 'setup' ? <SetupPanel /> : leftTab.value === 'plans' ? <PlansPanel /> : <DataPanel />}
        </div>
        <LayersPanel />
        <p class="disclaimer">Not for navigation; check before flight.</p>
      </aside>
      <MapPanel />
      <aside class="right" id="right" aria-label="Waypoints" tabIndex={-1}>
        <WaypointsPanel />
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
