#include "api/routes/processes/process_catalogue.hpp"

#include <algorithm>

namespace floeplan::routes {

const std::vector<ProcessEntry>& all_processes() {
  static const std::vector<ProcessEntry> processes{
      {"plan-route",
       "Plan a route",
       "The fastest route through currents, past land, shallows and icebergs: for one departure, for the "
       "best of a "
       "window, or for the latest that arrives in time. When there is none, the result says where, why and "
       "what would "
       "help.",
       "PlanInputs",
       {{"plan", "The plan"}}},
      {"evaluate-route",
       "Time a given route",
       "Travel time and clearances of a given route, by the rules that planning follows.",
       "EvaluateInputs",
       {{"evaluation", "The timed route"}}},
      {"reach",
       "Show what can be reached",
       "The places that the vehicle can reach within given times, or from which it can still be somewhere in "
       "time, as "
       "GeoJSON polygons.",
       "ReachInputs",
       {{"reach", "A GeoJSON FeatureCollection, one MultiPolygon for each time"}}},
      {"ingest",
       "Read uploads into the store",
       "Recognises each file by its content, checks it and stores it whole, or refuses it and says why. A "
       "file that is "
       "refused is part of the report: the job is successful.",
       "IngestInputs",
       {{"report", "What became of each file"}},
       false},
      {"simulate-plan",
       "Fly a plan in the test bed",
       "Flies a stored plan by its own mission files in a simulated sea, once or many times, with errors of "
       "currents "
       "and sensors and with icebergs, with or without the obstacle avoidance system on board, and tells how "
       "arrivals, "
       "position errors, clearances and energy are spread.",
       "SimulateInputs",
       {{"simulation", "A row for each flight, and their statistics"}}},
      {"fly-scenario",
       "Fly through a made sea",
       "Flies the closed loop of vehicle, sensors and obstacle avoidance system through seas that are drawn "
       "from a seed and that no plan knows, and tells how the flights end. Stores nothing.",
       "ScenarioInputs",
       {{"scenario", "A row for each flight, and their statistics"}}},
      {"compare-flight",
       "Fly a logged dive again",
       "Flies the dives of a Slocum's logs again in the simulator and sets both side by side: time under "
       "water, dives, speed and place of surfacing. Stores nothing.",
       "CompareFlightInputs",
       {{"comparison", "Each dive as logged and as simulated, and the medians"}}},
      {"echo",
       "Give back what was sent",
       "Tries out a client: gives every input back under its own name, after a pause if one is asked for.",
       "EchoInputs",
       {{"echo", "The text that was sent"},
        {"numbers", "The numbers that were sent"},
        {"region", "The box that was sent"},
        {"text", "The plain text that was sent"},
        {"value", "The text or whole number that was sent"}},
       false}};
  return processes;
}

const ProcessEntry* find_process(const std::string& id) {
  const auto& processes = all_processes();
  const auto found = std::ranges::find(processes, id, &ProcessEntry::id);
  return found == processes.end() ? nullptr : &*found;
}

}  // namespace floeplan::routes
