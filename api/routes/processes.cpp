#include "api/codec/simulate_inputs.hpp"
#include "api/routes/parameters.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

json input(const std::string& title, json schema, bool required = false) {
  return {{"title", title}, {"schema", std::move(schema)}, {"minOccurs", required ? 1 : 0}};
}

json position_schema() {
  return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
}

json number_schema(double least, double most) {
  return {{"type", "number"}, {"minimum", least}, {"maximum", most}};
}

json one_of(std::vector<std::string> values) { return {{"type", "string"}, {"enum", std::move(values)}}; }

json dataset_schema() { return {{"type", "string"}, {"default", "newest"}}; }

json several_datasets_schema() {
  const json ids{{"type", "array"}, {"items", {{"type", "string"}}}, {"minItems", 1}};
  return {{"oneOf", json::array({dataset_schema(), ids})}};
}

json spacing_schema() {
  const json pair{{"type", "array"}, {"items", number_schema(10.0, 1e5)}, {"minItems", 2}, {"maxItems", 2}};
  return {{"oneOf", json::array({number_schema(10.0, 1e5), pair})}};
}

json vehicle_schema() {
  return {{"oneOf", json::array({json{{"type", "string"}}, json{{"type", "object"}}})}};
}

json objective_schema() {
  const json weights{{"type", "object"},
                     {"properties", {{"time", number_schema(0.0, 1e6)}, {"energy", number_schema(0.0, 1e6)}}},
                     {"additionalProperties", false}};
  return {{"oneOf", json::array({one_of({"time", "energy"}), weights})}};
}

json file_schema() {
  const json text{{"type", "string"}};
  return {{"type", "object"},
          {"required", {"name", "text"}},
          {"properties", {{"name", text}, {"text", text}}},
          {"additionalProperties", false}};
}

json under_ice_schema() {
  const json share = number_schema(0.0, 1.0);
  const json thickness = number_schema(0.0, 500.0);
  const json time = number_schema(60.0, 3.2e7);
  return {{"type", "object"},
          {"additionalProperties", false},
          {"properties",
           {{"max_concentration_to_surface", share},
            {"margin_below_ice_m", thickness},
            {"draft_if_unknown_m", thickness},
            {"max_time_without_surfacing_s", time},
            {"surfacing_interval_s", time},
            {"escape_plan", {{"type", "boolean"}}},
            {"dead_reckoning_share", share},
            {"current_uncertainty_m_s", number_schema(0.0, 5.0)}}}};
}

json common_inputs() {
  const json time{{"type", "string"}, {"format", "date-time"}};
  return {
      {"depart", input("Departure, ISO 8601 with its zone", time, true)},
      {"vehicle",
       input("Vehicle: a name of /vehicles, or an object with one as profile and the members changed",
             vehicle_schema())},
      {"speed_m_s", input("Horizontal speed through the water, m/s", number_schema(0.05, 5.0))},
      {"pitch_deg", input("Pitch of dives and climbs; without a speed it gives that of the steady glide",
                          number_schema(vehicle::least_pitch_deg, vehicle::most_pitch_deg))},
      {"climb_to_m", input("Top of the saw-tooth, metres", number_schema(0.0, 11000.0))},
      {"dive_depth_m", input("Bottom of the saw-tooth in deep water, metres", number_schema(1.0, 11000.0))},
      {"altimeter_margin_m", input("Kept above the sea bed, metres", number_schema(0.0, 1000.0))},
      {"battery_j", input("Energy of the full battery, joules", number_schema(1.0, 1e10))},
      {"objective",
       input("What to minimise: time, energy, or weights of a second and of a joule", objective_schema())},
      {"thruster", input("Use of the thruster", one_of({"auto", "on", "off"}))},
      {"require_battery", input("No plan beyond what the battery gives", {{"type", "boolean"}})},
      {"battery_start_share", input("Share of it at the departure", number_schema(0.0, 1.0))},
      {"margin_m", input("Distance kept from the edge of an iceberg, metres", number_schema(0.0, 1e5))},
      {"areas",
       input(
           "Areas to keep out of or to stay in: GeoJSON polygons with the properties kind (no_go, stay_in), "
           "from, until, top_m, bottom_m",
           json{{"type", "object"}})},
      {"icebergs_drift", input("Let icebergs drift and their positions age; false: they stay where seen",
                               {{"type", "boolean"}})},
      {"max_inflation_m", input("Most that is kept from an iceberg for the error of its position, metres",
                                number_schema(0.0, 1e5))},
      {"max_sighting_age_days",
       input("Leave out icebergs last seen longer ago, by whole UTC days", number_schema(0.0, 30.0))},
      {"pass_under_icebergs",
       input("Pass under icebergs of known size whose keels end above the dives: never without being asked",
             {{"type", "boolean"}})},
      {"keel_clearance_m",
       input("Kept below the deepest keel when passing under, metres", number_schema(0.0, 1000.0))},
      {"draft_uncertainty",
       input("Share added to every iceberg's draft when passing under", number_schema(0.0, 2.0))},
      {"max_loiter_s",
       input("Longest wait at a waypoint for what clears later, seconds; 0: the vehicle never waits. It "
             "keeps its "
             "place by making way, where the current is weaker than its speed, and draws energy meanwhile",
             number_schema(0.0, 864'000.0))},
      {"currents", input("Currents: newest, none, an id or several ids", several_datasets_schema())},
      {"steady", input("Use one time step, or the mean, of the currents at any time", {{"type", "boolean"}})},
      {"tides", input("Tides: none (default), newest, an id or several ids of models with currents",
                      several_datasets_schema())},
      {"tides_mode", input("What tides are for: add them to currents that are without, or use them alone",
                           one_of({"add", "only"}))},
      {"wind", input("Wind, which moves icebergs: newest, none or an id", dataset_schema())},
      {"bathymetry", input("Bathymetry: newest, none or an id", dataset_schema())},
      {"ice", input("Sea ice: newest, none or an id", dataset_schema())},
      {"icebergs", input("Icebergs: newest, none or an id", dataset_schema())},
      {"icebergs_as_of", input("Use no sighting later than this; default: the departure", time)},
      {"under_ice", input("How the vehicle may work where there is sea ice", under_ice_schema())},
      {"coastline", input("Coastline: newest, none or an id", dataset_schema())},
      {"zones", input("Stored zones, obeyed beside the areas: all, none, an id or several ids",
                      several_datasets_schema())},
      {"name", input("Name of the result, for people", {{"type", "string"}, {"maxLength", 200}})}};
}

json plan_inputs() {
  const json time{{"type", "string"}, {"format", "date-time"}};
  json inputs = common_inputs();
  inputs["depart"] = input("Departure, ISO 8601 with its zone; required unless arrive_by is given", time);
  inputs["depart_until"] =
      input("Last departure of a window that begins at depart; the best one is planned", time);
  inputs["depart_step"] = input("From one departure of the window to the next, ISO 8601; default PT1H",
                                {{"type", "string"}, {"format", "duration"}});
  inputs["arrive_by"] =
      input("Leave as late as this arrival allows; depart is then the earliest departure", time);
  inputs["from"] = input("Start, [longitude, latitude] in degrees", position_schema());
  inputs["to"] = input("Goal, [longitude, latitude] in degrees", position_schema());
  inputs["goals_file"] = input(
      "File whose places take the place of via and to; without from the first of them is the start: "
      "GliderDOS "
      ".ma or .mi, GPX, KML, GeoJSON, CSV, NMEA, Seaglider targets, an IMC plan",
      file_schema());
  inputs["via"] = input("Places to visit in this order", {{"type", "array"}, {"items", position_schema()}});
  inputs["uncertainty"] = input(
      "How certain the currents are and what to make the best of: members, current_error_m_s, "
      "length_scale_m, time_scale_s, seed, objective (mean, quantile), quantile, arrive_before",
      {{"type", "object"}});
  inputs["via_order"] =
      input("Visit the places in the order given or in the one that reaches the goal earliest",
            one_of({"given", "best"}));
  inputs["spacing_m"] = input("Spacing of the search grid, metres, or [along, across]", spacing_schema());
  inputs["sectors"] =
      input("Reach of the grid's edges", {{"type", "integer"}, {"minimum", 1}, {"maximum", 5}});
  inputs["method"] = input("Search", one_of({"tve", "dijkstra", "astar", "frozen", "direct"}));
  inputs["max_waypoints"] =
      input("Waypoints at most", {{"type", "integer"}, {"minimum", 2}, {"maximum", 10000}});
  inputs["max_leg_m"] =
      input("Length of the longest leg, metres; longer ones are parted", number_schema(100.0, 5e6));
  inputs["encounter_weight_s"] = input(
      "Seconds of travel that one expected encounter with an iceberg counts as; 0: encounters are stated, "
      "not avoided",
      number_schema(0.0, 1e7));
  inputs["refine_seconds"] =
      input("Computing time for refinement at most, seconds; default 1", number_schema(0.05, 60.0));
  inputs["refine"] = input("Move waypoints off the grid where that saves time", {{"type", "boolean"}});
  inputs["optimality_gap"] = input("Compare the plan with the best way in open water", {{"type", "boolean"}});
  return inputs;
}

json evaluate_inputs() {
  json inputs = common_inputs();
  inputs["route"] = input("GeoJSON LineString or an array of positions; else plan_id",
                          {{"oneOf", json::array({json{{"type", "object"}},
                                                  json{{"type", "array"}, {"items", position_schema()}}})}});
  inputs["route_file"] = input("File with the route, as goals_file; instead of route", file_schema());
  inputs["from"] = input("Start of a route from a file, [longitude, latitude] in degrees", position_schema());
  inputs["plan_id"] = input("A stored plan whose route is meant", {{"type", "string"}});
  return inputs;
}

json reach_inputs() {
  const json time{{"type", "string"}, {"format", "date-time"}};
  const json hours = number_schema(0.0, 720.0);
  json inputs = common_inputs();
  inputs.erase("max_loiter_s");
  inputs["depart"] = input("Departure, with from", time);
  inputs["arrive_by"] = input("Latest arrival, with to", time);
  inputs["from"] =
      input("Where the vehicle leaves, [longitude, latitude] in degrees; else to", position_schema());
  inputs["to"] = input("Where it is to arrive, [longitude, latitude] in degrees", position_schema());
  inputs["hours"] = input(
      "Hours after the departure, or before the arrival; one number or several",
      {{"oneOf",
        json::array({hours, json{{"type", "array"}, {"items", hours}, {"minItems", 1}, {"maxItems", 48}}})}},
      true);
  inputs["spacing_m"] = input("Spacing of the search grid, metres", number_schema(10.0, 1e5));
  inputs["sectors"] =
      input("Reach of the grid's edges", {{"type", "integer"}, {"minimum", 1}, {"maximum", 5}});
  return inputs;
}

json ingest_inputs() {
  const json text{{"type", "string"}, {"maxLength", 200}};
  const json ids{{"type", "array"}, {"items", {{"type", "string"}}}, {"minItems", 1}, {"maxItems", 1000}};
  return {
      {"uploads",
       input(
           "Ids of uploads; files that belong together (both components of a current, a model's grid) in one "
           "request",
           ids, true)},
      {"name", input("Name of the dataset; default: the file's name", text)},
      {"kind", input("What to take the files for; default: recognised",
                     one_of({"auto", "bathymetry", "currents", "ice", "icebergs", "coastline", "tides",
                             "wind", "zones"}))},
      {"crs", input("Reference system of a file that states none, as EPSG:4326", text)},
      {"positive",
       input("Sign of bathymetry that does not say: up (elevation) or down (depth)", one_of({"up", "down"}))},
      {"variable",
       input("Concentration of sea ice to use when a file holds several; default: the greatest", text)},
      {"at",
       input("Where a station of the tide is whose file does not say it, [longitude, latitude] in degrees",
             position_schema())},
      {"unit",
       input("Of a station's amplitudes where its file does not say it", one_of({"m", "cm", "mm", "ft"}))},
      {"zone_kind", input("Rule of zones whose file states none", one_of({"no_go", "stay_in"}))}};
}

json simulate_inputs() {
  const json object{{"type", "object"}};
  const json text{{"type", "string"}};
  const auto integer = [](int least, int most) {
    return json{{"type", "integer"}, {"minimum", least}, {"maximum", most}};
  };
  return {
      {"plan_id", input("The stored plan to fly", text, true)},
      {"mission_files",
       input("Mission files to fly instead of those that the plan is exported as",
             {{"type", "array"}, {"items", file_schema()}, {"minItems", 1}, {"maxItems", 100}})},
      {"vehicle", input("Refuse a plan for another vehicle than this", text)},
      {"runs",
       input("Flights, each with errors and icebergs of its own; default 1", integer(1, codec::most_runs))},
      {"seed",
       input("Of all chance: the same seed gives the same flights; default 1", integer(0, 2'000'000'000))},
      {"tracks", input("Flights to keep whole, the first ones; default 10", integer(0, codec::most_tracks))},
      {"avoidance",
       input("Fly with sonar, ADCP and the obstacle avoidance system; default true", {{"type", "boolean"}})},
      {"current_error",
       input("How far the currents are from the forecast: rms_m_s, length_scale_m, depth_scale_m, "
             "time_scale_s",
             object)},
      {"sonar", input("Settings of the sonar that differ from the defaults", object)},
      {"altimeter", input("Settings of the altimeter that differ from the defaults", object)},
      {"adcp", input("Settings of the ADCP that differ from the defaults", object)},
      {"navigation",
       input("Errors of the vehicle's own sensors: compass_sigma_deg, speed_sigma_share, fix_sigma_m, "
             "current_sigma_m_s",
             object)},
      {"longest_s", input("Longest flight, seconds; default thrice the planned time and a day",
                          number_schema(60.0, 90.0 * 86400.0))},
      {"record_every_s",
       input("From one point of a track to the next, seconds; default 60", number_schema(1.0, 86400.0))},
      {"currents", input("True currents: newest, none, an id or several ids; default the plan's choice",
                         several_datasets_schema())},
      {"steady", input("As of plan-route; default the plan's choice", {{"type", "boolean"}})},
      {"tides", input("As of plan-route; default the plan's choice", several_datasets_schema())},
      {"tides_mode", input("As of plan-route; default the plan's choice", one_of({"add", "only"}))},
      {"bathymetry", input("Sea bed: newest, none or an id; default the plan's choice", dataset_schema())},
      {"ice", input("Sea ice: newest, none or an id; default the plan's choice", dataset_schema())},
      {"icebergs", input("Icebergs: newest, none or an id; default the plan's choice", dataset_schema())},
      {"icebergs_as_of", input("Use no sighting later than this; default the plan's choice",
                               {{"type", "string"}, {"format", "date-time"}})},
      {"name", input("Name of the simulation, for people", {{"type", "string"}, {"maxLength", 200}})}};
}

json process(const std::string& id, const std::string& title, const std::string& description) {
  return {{"id", id},
          {"title", title},
          {"description", description},
          {"version", FLOEPLAN_VERSION},
          {"jobControlOptions", json::array({"async-execute", "sync-execute", "dismiss"})},
          {"outputTransmission", json::array({"value"})}};
}

/// What a process takes and gives beside its summary.
struct Description {
  json summary;
  json (*inputs)();
  std::string output;
  std::string output_title;
};

std::vector<Description> descriptions() {
  return {
      {process("plan-route", "Plan a route",
               "The fastest route through currents, past land, shallows and icebergs: for one departure, for "
               "the best of a window, or for the latest that arrives in time. When there is none, the result "
               "says where, why and what would help."),
       plan_inputs, "plan", "The plan"},
      {process("evaluate-route", "Time a given route",
               "Travel time and clearances of a given route, by the rules that planning follows."),
       evaluate_inputs, "evaluation", "The timed route"},
      {process("reach", "Show what can be reached",
               "The places that the vehicle can reach within given times, or from which it can still be "
               "somewhere "
               "in time, as GeoJSON polygons."),
       reach_inputs, "reach", "A GeoJSON FeatureCollection, one MultiPolygon for each time"},
      {process("ingest", "Read uploads into the store",
               "Recognises each file by its content, checks it and stores it whole, or refuses it and says "
               "why. A file "
               "that is refused is part of the report: the job is successful."),
       ingest_inputs, "report", "What became of each file"},
      {process("simulate-plan", "Fly a plan in the test bed",
               "Flies a stored plan by its own mission files in a simulated sea, once or many times, with "
               "errors of "
               "currents and sensors and with icebergs, with or without the obstacle avoidance system on "
               "board, and "
               "tells how arrivals, position errors, clearances and energy are spread."),
       simulate_inputs, "simulation", "A row for each flight, and their statistics"}};
}

json with_links(json summary, const std::string& url) {
  const std::string self = url + "/processes/" + summary.at("id").get<std::string>();
  summary["links"] = json::array(
      {link("self", "application/json", self),
       link("http://www.opengis.net/def/rel/ogc/1.0/execute", "application/json", self + "/execution")});
  return summary;
}

Response list_processes(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const auto limit = static_cast<std::size_t>(reader.limit());
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  json processes = json::array();
  for (const auto& known : descriptions()) {
    if (processes.size() < limit) processes.push_back(with_links(known.summary, context.service.public_url));
  }
  const std::string self = context.service.public_url + "/processes";
  return json_reply(
      {{"processes", processes}, {"links", json::array({link("self", "application/json", self)})}});
}

Response show_process(const Context& context, const Request& request, const PathParameters& path) {
  const std::string& id = path.at("process_id");
  for (const auto& known : descriptions()) {
    if (known.summary.at("id") != id) continue;
    json description = with_links(known.summary, context.service.public_url);
    description["inputs"] = known.inputs();
    description["outputs"][known.output] = {{"title", known.output_title}, {"schema", {{"type", "object"}}}};
    return json_reply(description);
  }
  return not_found(request, "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/no-such-process",
                   "No process has the id " + id + ".");
}

}  // namespace

std::vector<Route> process_routes() {
  return {{"GET", "/processes", {"limit"}, list_processes},
          {"GET", "/processes/{process_id}", {}, show_process}};
}

}  // namespace floeplan::routes
