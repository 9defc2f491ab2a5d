import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { emptyDraft } from '../../src/model/setup/draft';

interface Schema {
  $ref?: string;
  allOf?: Schema[];
  oneOf?: Schema[];
  properties?: Record<string, Schema>;
}
const document = JSON.parse(readFileSync(new URL('../../../api/openapi/openapi.json', import.meta.url), 'utf8')) as {
  components: { schemas: Record<string, Schema> };
};

function membersOf({ $ref, allOf = [], oneOf = [], properties = {} }: Schema): Record<string, Schema> {
  const named = $ref === undefined ? undefined : document.components.schemas[$ref.split('/').at(-1) ?? ''];
  return Object.assign({}, ...[...(named ? [named] : []), ...allOf, ...oneOf].map(membersOf), properties) as Record<string, Schema>;
}

/** The keys of a request, those of members of members with a dot, as the set-up names its fields. */
const keys = Object.entries(membersOf({ $ref: '#/components/schemas/PlanInputs' })).flatMap(([name, schema]) => {
  const inner = Object.keys(name === 'areas' || name === 'goals_file' ? {} : membersOf(schema));
  const isAlsoPlain = name === 'vehicle' || name === 'objective' || inner.length === 0;
  return isAlsoPlain ? [name, ...inner.map((member) => `${name}.${member}`)] : inner.map((member) => `${name}.${member}`);
});

/** What the set-up leaves out, and why. */
const leftOut: Record<string, string[]> = {
  'written by programs that read places from files, not by people': ['remarks'],
  'the name of the vehicle chosen, which the set-up sends itself': ['vehicle.profile'],
  'the words a vehicle is known by change no plan': ['vehicle.name', 'vehicle.title'],
  'measured once for a type of vehicle, and kept in its profile': [
    'vehicle.parasite_drag', 'vehicle.induced_drag', 'vehicle.lift_slope', 'vehicle.drag_area_m2', 'vehicle.pump_efficiency',
    'vehicle.pump_loss_j_cm3', 'vehicle.intake_j_cm3', 'vehicle.inflection_j', 'vehicle.thruster',
  ],
  'fields of the set-up of their own, beside the vehicle': [
    'vehicle.speed_m_s', 'vehicle.pitch_deg', 'vehicle.climb_to_m', 'vehicle.dive_depth_m', 'vehicle.altimeter_margin_m', 'vehicle.battery_j',
    'vehicle.battery_start_share',
  ],
};

describe('the options of a request', () => {
  it('have each a field in the set-up, or a reason to have none', () => {
    const offered = Object.keys(emptyDraft);
    const excused = Object.values(leftOut).flat();
    expect(keys.filter((key) => !offered.includes(key) && !excused.includes(key))).toEqual([]);
    expect(excused.filter((key) => !keys.includes(key) || offered.includes(key))).toEqual([]);
  });

  it('are known to the server under the name of their field', () => {
    expect(Object.keys(emptyDraft).filter((field) => !keys.includes(field))).toEqual([]);
  });
});
