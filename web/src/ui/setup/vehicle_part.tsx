import type { VNode } from 'preact';
import type { Vehicle } from '../../contract/data_types';
import { vehicles } from '../../model/datasets';
import { draft } from '../../model/setup/draft';
import { factorOf, formOf, type NumberField } from '../../model/fields';
import { CheckField, SelectField, TextField } from './field';
import { Part } from './part';

/** The objective, the flight parameters, and the differences of this vehicle from its profile. */
export function VehiclePart(): VNode {
  return (
    <Part title="Vehicle">
      <SelectField name="objective" choices={[{ value: 'time', title: 'Travel time' }, { value: 'energy', title: 'Energy' }, { value: 'both', title: 'Both, weighted' }]} />
      {draft.value.objective === 'both' && (
        <div class="field-pair">
          <TextField name="objective.time" />
          <TextField name="objective.energy" />
        </div>
      )}
      <div class="field-pair">
        <ProfileField name="speed_m_s" />
        <ProfileField name="dive_depth_m" />
      </div>
      <div class="field-pair">
        <ProfileField name="climb_to_m" />
        <ProfileField name="altimeter_margin_m" />
      </div>
      <div class="field-pair">
        <ProfileField name="battery_j" />
        <ProfileField name="battery_start_share" />
      </div>
      <ProfileField name="pitch_deg" />
      <SelectField name="thruster" choices={[{ value: 'auto', title: 'Where it helps' }, { value: 'on', title: 'Always' }, { value: 'off', title: 'Never' }]} />
      <CheckField name="require_battery" />
      <div class="field-pair">
        <ProfileField name="vehicle.hotel_w" />
        <ProfileField name="vehicle.battery_reserve_share" />
      </div>
      <div class="field-pair">
        <ProfileField name="vehicle.surfacing_interval_s" />
        <ProfileField name="vehicle.surfacing_j" />
      </div>
      <div class="field-pair">
        <ProfileField name="vehicle.depth_rating_m" />
        <ProfileField name="vehicle.minimum_working_depth_m" />
      </div>
      <div class="field-pair">
        <ProfileField name="vehicle.buoyancy_cm3" />
        <ProfileField name="vehicle.max_waypoints_per_list" />
      </div>
    </Part>
  );
}

type Built = { [K in keyof Vehicle]-?: NonNullable<Vehicle[K]> extends number ? K : never }[keyof Vehicle];

/** A number whose default is that of the vehicle profile. */
function ProfileField({ name }: { name: NumberField }): VNode {
  const vehicle = vehicles.value.find((known) => known.name === draft.value.vehicle) ?? vehicles.value[0];
  const value = vehicle?.[name.replace('vehicle.', '') as Built];
  const placeholder = typeof value === 'number' ? String(Number((value / factorOf(name)).toPrecision(4))) : formOf(name).placeholder;
  return <TextField name={name} placeholder={placeholder} />;
}
