import type { VNode } from 'preact';
import chevronRight from 'lucide-static/icons/chevron-right.svg?raw';
import clock from 'lucide-static/icons/clock.svg?raw';
import compare from 'lucide-static/icons/git-compare-arrows.svg?raw';
import compass from 'lucide-static/icons/compass.svg?raw';
import crosshair from 'lucide-static/icons/crosshair.svg?raw';
import database from 'lucide-static/icons/database.svg?raw';
import download from 'lucide-static/icons/download.svg?raw';
import edit from 'lucide-static/icons/pencil.svg?raw';
import eye from 'lucide-static/icons/eye.svg?raw';
import eyeOff from 'lucide-static/icons/eye-off.svg?raw';
import file from 'lucide-static/icons/file-input.svg?raw';
import hand from 'lucide-static/icons/hand.svg?raw';
import help from 'lucide-static/icons/circle-help.svg?raw';
import info from 'lucide-static/icons/info.svg?raw';
import list from 'lucide-static/icons/list.svg?raw';
import lock from 'lucide-static/icons/lock.svg?raw';
import maximize from 'lucide-static/icons/maximize.svg?raw';
import minus from 'lucide-static/icons/minus.svg?raw';
import moon from 'lucide-static/icons/moon.svg?raw';
import pause from 'lucide-static/icons/pause.svg?raw';
import play from 'lucide-static/icons/play.svg?raw';
import plus from 'lucide-static/icons/plus.svg?raw';
import polygon from 'lucide-static/icons/pentagon.svg?raw';
import probe from 'lucide-static/icons/scan-search.svg?raw';
import reach from 'lucide-static/icons/radar.svg?raw';
import redo from 'lucide-static/icons/redo-2.svg?raw';
import refresh from 'lucide-static/icons/rotate-ccw.svg?raw';
import route from 'lucide-static/icons/route.svg?raw';
import share from 'lucide-static/icons/link.svg?raw';
import save from 'lucide-static/icons/save.svg?raw';
import settings from 'lucide-static/icons/sliders-horizontal.svg?raw';
import skipBack from 'lucide-static/icons/skip-back.svg?raw';
import skipForward from 'lucide-static/icons/skip-forward.svg?raw';
import stepBack from 'lucide-static/icons/step-back.svg?raw';
import stepForward from 'lucide-static/icons/step-forward.svg?raw';
import sun from 'lucide-static/icons/sun.svg?raw';
import trash from 'lucide-static/icons/trash-2.svg?raw';
import undo from 'lucide-static/icons/undo-2.svg?raw';
import user from 'lucide-static/icons/circle-user.svg?raw';
import up from 'lucide-static/icons/chevron-up.svg?raw';
import upload from 'lucide-static/icons/upload.svg?raw';
import warning from 'lucide-static/icons/triangle-alert.svg?raw';
import x from 'lucide-static/icons/x.svg?raw';

const icons = {
  chevronRight, clock, compare, compass, crosshair, database, download, edit, eye, eyeOff, file, hand, help, info, list, lock, maximize, minus, moon,
  pause, play, plus, polygon, probe, reach, redo, refresh, route, save, settings, share, skipBack, skipForward, stepBack, stepForward, sun, trash, undo, up, upload,
  user, warning, x,
};

export type IconName = keyof typeof icons;

/** A decorative drawing; the text beside it or the button around it has the words. */
export function Icon({ name, size = 16 }: { name: IconName; size?: number }): VNode {
  const inner = icons[name].replace(/^[\s\S]*?<svg[\s\S]*?>/, '').replace('</svg>', '');
  return (
    <svg
      class="icon" width={size} height={size} viewBox="0 0 24 24" fill="none" stroke="currentColor" stroke-width="2"
      stroke-linecap="round" stroke-linejoin="round" aria-hidden="true" focusable="false"
      dangerouslySetInnerHTML={{ __html: inner }}
    />
  );
}

interface IconButtonProps {
  icon: IconName;
  label: string;
  hint?: string | undefined; // tooltip, also read after the label
  onClick: (event: MouseEvent) => void;
  pressed?: boolean;
  disabled?: boolean;
  class?: string;
}

export function IconButton({ icon, label, hint, onClick, pressed, disabled, class: extra }: IconButtonProps): VNode {
  return (
    <button
      type="button" class={`icon-button ${extra ?? ''}`} aria-label={label} title={hint ? `${label}: ${hint}` : label} aria-pressed={pressed}
      disabled={disabled} onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}
