import type { VNode } from 'preact';
import type { Vehicle } from '../../api/data_types';
import { vehicles } from '../../model/datasets';
import { draft, type Field } from '../../model/draft';
import { CheckField, SelectField, TextField } from './field';
import { Part } from './part';

const fields: Field[] = [
  'objective', 'objective.time', 'objective.energy', 'speed_m_s', 'dive_depth_m', 'pitch_deg', 'climb_to_m', 'altimeter_margin_m',
  'battery_j', 'battery_start_share', 'require_battery', 'thruster', 'vehicle.depth_rating_m', 'vehicle.minimum_working_depth_m',
  'vehicle.buoyancy_cm3', 'vehicle.hotel_w', 'vehicle.surfacing_interval_s', 'vehicle.surfacing_j', 'vehicle.battery_reserve_share',
  'vehicle.max_waypoints_per_list',
];

type Built = { [K in keyof Vehicle]-?: NonNullable<Vehicle[K]> extends number ? K : never }[keyof Vehicle];

/** What is optimised, how the vehicle flies, and what differs in this one from the others of its kind. */
export function VehiclePart(): VNode {
  const vehicle = vehicles.value.find(({ name }) => name === draft.value.vehicle) ?? vehicles.value[0];
  const built = (name: Built, factor = 1): string | undefined => {
    const value = vehicle?.[name];
    return typeof value === 'number' ? String(Number((value * factor).toPrecision(4))) : undefined;
  };
  return (
    <Part title="Vehicle" fields={fields}>
      <SelectField name="objective" label="Optimise" choices={[{ value: 'time', title: 'Travel time' }, { value: 'energy', title: 'Energy' }, { value: 'both', title: 'Both, weighted' }]} />
      {draft.value.objective === 'both' && (
        <div class="field-pair">
          <TextField name="objective.time" label="A second weighs" inputMode="decimal" />
          <TextField name="objective.energy" label="A joule weighs" inputMode="decimal" />
        </div>
      )}
      <div class="field-pair">
        <TextField name="speed_m_s" label="Water speed" unit="m/s" inputMode="decimal" placeholder={built('speed_m_s')} />
        <TextField name="dive_depth_m" label="Dive depth" unit="m" inputMode="decimal" placeholder={built('dive_depth_m')} />
      </div>
      <div class="field-pair">
        <TextField name="climb_to_m" label="Climb to" unit="m" inputMode="decimal" placeholder={built('climb_to_m')} />
        <TextField name="altimeter_margin_m" label="Above bed" unit="m" inputMode="decimal" placeholder={built('altimeter_margin_m')} />
      </div>
      <div class="field-pair">
        <TextField name="battery_j" label="Battery" unit="MJ" inputMode="decimal" placeholder={built('battery_j', 1e-6)} />
        <TextField name="battery_start_share" label="Charged" unit="%" inputMode="decimal" placeholder={built('battery_start_share', 100)} />
      </div>
      <TextField name="pitch_deg" label="Pitch" unit="°" inputMode="decimal" placeholder={built('pitch_deg')} />
      <SelectField name="thruster" label="Thruster" choices={[{ value: 'auto', title: 'Where it helps' }, { value: 'on', title: 'Always' }, { value: 'off', title: 'Never' }]} />
      <CheckField name="require_battery" label="Only plans that the battery lasts for" />
      <div class="field-pair">
        <TextField name="vehicle.hotel_w" label="Hotel load" unit="W" inputMode="decimal" placeholder={built('hotel_w')} />
        <TextField name="vehicle.battery_reserve_share" label="Reserve" unit="%" inputMode="decimal" placeholder={built('battery_reserve_share', 100)} />
      </div>
      <div class="field-pair">
        <TextField name="vehicle.surfacing_interval_s" label="Surfaces every" unit="h" inputMode="decimal" placeholder={built('surfacing_interval_s', 1 / 3600) ?? 'as it must'} />
        <TextField name="vehicle.surfacing_j" label="A surfacing" unit="kJ" inputMode="decimal" placeholder={built('surfacing_j', 1e-3)} />
      </div>
      <div class="field-pair">
        <TextField name="vehicle.depth_rating_m" label="Rated to" unit="m" inputMode="decimal" placeholder={built('depth_rating_m')} />
        <TextField name="vehicle.minimum_working_depth_m" label="Least depth" unit="m" inputMode="decimal" placeholder={built('minimum_working_depth_m')} />
      </div>
      <div class="field-pair">
        <TextField name="vehicle.buoyancy_cm3" label="Buoyancy" unit="cm³" inputMode="decimal" placeholder={built('buoyancy_cm3')} />
        <TextField name="vehicle.max_waypoints_per_list" label="List holds" unit="waypoints" inputMode="numeric" placeholder={built('max_waypoints_per_list')} />
      </div>
    </Part>
  );
}
