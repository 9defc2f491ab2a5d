#pragma once

#include "api/problems/problem.hpp"
#include "engine/messages/kind.hpp"

/// The catalogue of all problems in the server's responses.
namespace floeplan::problems {

/// A row of the catalogue.
struct ProblemKind {
  std::string_view code;
  int status;
  std::string_view title;
  std::string_view detail;  // a text with slots, as in messages::Kind
  std::array<messages::Slot, 7> slots{};
  std::string_view type{};  // the slug, if it differs from the code

  [[nodiscard]] constexpr std::string_view slug() const { return type.empty() ? code : type; }
  /// The detail as a kind of message, to fill in its slots.
  [[nodiscard]] constexpr messages::Kind words() const {
    return {.code = code, .rank = messages::Rank::note, .text = detail, .slots = slots};
  }
};

inline constexpr auto problem_kinds = std::to_array<ProblemKind>({
    // Requests that do not reach a resource.
    {.code = "invalid-http",
     .status = 400,
     .title = "Invalid request",
     .detail = "The request is not valid HTTP/1.1.",
     .type = "invalid-request"},
    {.code = "invalid-target",
     .status = 400,
     .title = "Invalid request",
     .detail = "The address of the request is not valid."},
    {.code = "target-too-long",
     .status = 414,
     .title = "Target too long",
     .detail = "The address is longer than 16 KiB."},
    {.code = "header-too-large",
     .status = 431,
     .title = "Header too large",
     .detail = "The header is larger than 16 KiB."},
    {.code = "body-too-large",
     .status = 413,
     .title = "Body too large",
     .detail = "The body is larger than {most_mib} MiB.",
     .slots = {{{"most_mib", 64}}}},
    {.code = "body-not-kept",
     .status = 507,
     .title = "Insufficient storage",
     .detail = "The server cannot write the body to its disk.",
     .type = "insufficient-storage"},
    {.code = "busy",
     .status = 503,
     .title = "Busy",
     .detail = "Requests use all the memory that the server gives them; send the request again in a moment."},
    {.code = "too-many-streams",
     .status = 503,
     .title = "Too many streams",
     .detail = "Too many event streams are open; ask again later."},
    {.code = "too-many-streams-of-client",
     .status = 429,
     .title = "Too many streams",
     .detail = "You have {most} event streams open, the most for one client; close some. One stream of "
               "/events reports all jobs.",
     .slots = {{{"most", 20}}},
     .type = "too-many-streams"},
    {.code = "too-many-files",
     .status = 429,
     .title = "Too many files at once",
     .detail = "{most} files are on their way between you and the server, the most for one client at a time; "
               "try again when one of them has arrived.",
     .slots = {{{"most", 8}}}},

    // Authentication and authorisation.
    {.code = "no-token",
     .status = 400,
     .title = "No token",
     .detail = "A login needs a token: as {{\"token\": \"...\"}} or in the Authorization header. A server "
               "without tokens needs no login."},
    {.code = "unauthorized",
     .status = 401,
     .title = "Unauthorized",
     .detail = "The request carries no token. Send one as \"Authorization: Bearer TOKEN\", or log in with it "
               "by POST /session. The operator makes tokens on the server: floeplan token add NAME --role "
               "ROLE."},
    {.code = "unknown-token",
     .status = 401,
     .title = "Unauthorized",
     .detail = "The token is not known; it may have been revoked. Ask for a new one: it is made on the "
               "server's machine with floeplan token add NAME --role ROLE.",
     .type = "unauthorized"},
    {.code = "token-just-revoked",
     .status = 401,
     .title = "Unauthorized",
     .detail = "The token has just been revoked.",
     .type = "unauthorized"},
    {.code = "forbidden",
     .status = 403,
     .title = "Forbidden",
     .detail = "This needs the role {needed}, but your token has the role {given}; ask the operator for "
               "another token.",
     .slots = {{{"needed", "pilot"}, {"given", "viewer"}}}},
    {.code = "foreign-page",
     .status = 403,
     .title = "Forbidden",
     .detail = "A page of another site sent this request, and the server does not allow that site; the "
               "operator allows a site with --allow-origin."},
    {.code = "unknown-host",
     .status = 421,
     .title = "Misdirected request",
     .detail = "This server is not known by the name {host}; start it with --public-url to give it one.",
     .slots = {{{"host", "ice.example.org"}}}},
    {.code = "too-many-wrong-tokens",
     .status = 429,
     .title = "Too many attempts",
     .detail = "Too many wrong tokens came from your address, or for this token; wait and try again.",
     .type = "too-many-attempts"},
    {.code = "too-many-logins",
     .status = 429,
     .title = "Too many attempts",
     .detail = "Too many logins were opened with this token, or from your address; keep the one you have, "
               "or wait and try again.",
     .type = "too-many-attempts"},
    {.code = "quota-uploads",
     .status = 403,
     .title = "Too many uploads",
     .detail = "You have {most} uploads waiting, the most for one token. This file was not kept. Remove "
               "some of yours with DELETE /uploads/{{id}} (GET /uploads lists them); each expires after a "
               "day.",
     .slots = {{{"most", 20}}}},
    {.code = "quota-stored-bytes",
     .status = 403,
     .title = "Too much is stored",
     .detail = "You have stored {stored_mb} MB of the {most_mb} MB for one token; {more_mb} MB more do not "
               "fit, and nothing of this request was kept. Remove what nobody needs: uploads with "
               "DELETE /uploads/{{id}} (GET /uploads lists them), datasets with DELETE /datasets/{{id}}, "
               "plans with DELETE /collections/plans/items/{{id}}, simulations with DELETE "
               "/simulations/{{id}}; or have the quota raised (serve --max-stored-mb).",
     .slots = {{{"stored_mb", 900}, {"most_mb", 1000}, {"more_mb", 200}}}},

    // Faults of the request.
    {.code = "invalid-request",
     .status = 400,
     .title = "Invalid request",
     .detail = "The request has faults; each is listed under \"errors\"."},
    {.code = "invalid-json",
     .status = 400,
     .title = "Invalid JSON",
     .detail = "{why}",
     .slots = {{{"why", "no value at byte 12"}}}},
    {.code = "no-json",
     .status = 415,
     .title = "Unsupported media type",
     .detail = "The body must be application/json.",
     .type = "unsupported-media-type"},
    {.code = "no-geojson",
     .status = 415,
     .title = "Unsupported media type",
     .detail = "The body must be application/geo+json.",
     .type = "unsupported-media-type"},
    {.code = "method-not-allowed",
     .status = 405,
     .title = "Method not allowed",
     .detail = "{method} is not possible here; allowed: {allowed}.",
     .slots = {{{"method", "PUT"}, {"allowed", "OPTIONS, GET, HEAD"}}}},
    {.code = "too-many-values",
     .status = 413,
     .title = "Too many values",
     .detail = "The answer would have {values} values, more than {most}; ask for less time, fewer depths or "
               "a coarser resolution.",
     .slots = {{{"values", 20000000}, {"most", 1000000}}}},
    {.code = "invalid-idempotency-key",
     .status = 400,
     .title = "Invalid Idempotency-Key",
     .detail = "An Idempotency-Key has 1 to 255 ASCII characters; take a UUID."},
    {.code = "idempotency-key-reused",
     .status = 409,
     .title = "Idempotency-Key used before",
     .detail = "Another request had this Idempotency-Key in the last 24 hours; take a new one."},
    {.code = "feature-from-a-file",
     .status = 409,
     .title = "Not to be changed",
     .detail = "{why}",
     .slots = {{{"why", "It comes from a file"}}}},
    {.code = "changed-meanwhile",
     .status = 412,
     .title = "Changed meanwhile",
     .detail = "The feature has another entity tag; read it again."},
    {.code = "dangerous-plan",
     .status = 409,
     .title = "The plan is dangerous",
     .detail = "The plan has dangers, in itself or in the newest data. Plan again, or confirm the dangers "
               "with accept_dangers=true."},

    // Objects that do not exist.
    {.code = "unknown-path",
     .status = 404,
     .title = "Not found",
     .detail = "The server has nothing at {path}; check the address. /api lists all addresses.",
     .slots = {{{"path", "/plans"}}}},
    {.code = "no-client",
     .status = 404,
     .title = "Not found",
     .detail = "This server was started without the browser client; start it with serve --web FOLDER."},
    {.code = "unknown-dataset",
     .status = 404,
     .title = "Not found",
     .detail = "No dataset has the id {id}.",
     .slots = {{{"id", "ice-1"}}}},
    {.code = "unknown-plan",
     .status = 404,
     .title = "Not found",
     .detail = "No plan has the id {id}.",
     .slots = {{{"id", "p0123456789ab"}}}},
    {.code = "unknown-simulation",
     .status = 404,
     .title = "Not found",
     .detail = "No simulation has the id {id}.",
     .slots = {{{"id", "s0123456789ab"}}}},
    {.code = "unknown-flight",
     .status = 404,
     .title = "Not found",
     .detail = "The flight {run} is not kept; a simulation keeps its first flights, as many as its input "
               "\"tracks\".",
     .slots = {{{"run", "12"}}}},
    {.code = "no-flight-kept",
     .status = 404,
     .title = "Not found",
     .detail = "No such flight of the simulation is kept.",
     .type = "unknown-flight"},
    {.code = "unknown-upload",
     .status = 404,
     .title = "Not found",
     .detail = "No upload has the id {id}; it was removed or has expired.",
     .slots = {{{"id", "u-1"}}}},
    {.code = "unknown-feature",
     .status = 404,
     .title = "Not found",
     .detail = "{collection} has no feature with the id {id}.",
     .slots = {{{"collection", "Icebergs"}, {"id", "12"}}}},
    {.code = "unknown-collection",
     .status = 404,
     .title = "Not found",
     .detail = "No collection has the id {id}.",
     .slots = {{{"id", "ships"}}}},
    {.code = "unknown-data-collection",
     .status = 404,
     .title = "Not found",
     .detail = "No collection with data has the id {id}.",
     .slots = {{{"id", "ships"}}},
     .type = "unknown-collection"},
    {.code = "no-data-in-area",
     .status = 404,
     .title = "Not found",
     .detail = "No {kind} data cover this area.",
     .slots = {{{"kind", "bathymetry"}}},
     .type = "no-data"},
    {.code = "no-data-in-area-then",
     .status = 404,
     .title = "Not found",
     .detail = "No {kind} data cover this area and time.",
     .slots = {{{"kind", "currents"}}},
     .type = "no-data"},
    {.code = "no-node-in-area",
     .status = 404,
     .title = "Not found",
     .detail = "The dataset has no node in this area.",
     .type = "no-data"},
    {.code = "no-node-in-area-then",
     .status = 404,
     .title = "Not found",
     .detail = "The dataset has no node in this area or no time around this one.",
     .type = "no-data"},
    {.code = "no-data-here",
     .status = 404,
     .title = "Not found",
     .detail = "No data of this collection cover this place and time.",
     .type = "no-data"},
    {.code = "no-data-because",
     .status = 404,
     .title = "Not found",
     .detail = "{why}",
     .slots = {{{"why", "The dataset ends before that."}}},
     .type = "no-data"},

    // Processes and jobs.
    {.code = "no-such-process",
     .status = 404,
     .title = "Not found",
     .detail = "No process has the id {id}.",
     .slots = {{{"id", "sail"}}},
     .type = "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/no-such-process"},
    {.code = "no-such-job",
     .status = 404,
     .title = "Not found",
     .detail = "No job has the id {id}.",
     .slots = {{{"id", "0123456789abcdef0"}}},
     .type = "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/no-such-job"},
    {.code = "result-not-ready",
     .status = 404,
     .title = "Results not ready",
     .detail = "The job has not ended yet; ask for its status.",
     .type = "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/result-not-ready"},
    {.code = "unknown-job",
     .status = 404,
     .title = "Not found",
     .detail = "The job was removed before it ended; send the request again."},
    {.code = "job-failed",
     .status = 400,
     .title = "The job failed",
     .detail = "{why}",
     .slots = {{{"why", "the disk is full"}}}},
    {.code = "job-dismissed",
     .status = 410,
     .title = "The job was dismissed",
     .detail = "A dismissed job has no results."},
    {.code = "job-removed",
     .status = 410,
     .title = "The job was removed",
     .detail = "The job that this Idempotency-Key began was removed; take a new key."},
    {.code = "queue-full",
     .status = 503,
     .title = "The queue is full",
     .detail = "Too many jobs are waiting, in total or of yours; try again later."},
    {.code = "not-ready",
     .status = 503,
     .title = "Not ready",
     .detail = "The server accepts no work: {why}.",
     .slots = {{{"why", "the disk is almost full"}}}},

    // The server and its store.
    {.code = "insufficient-storage",
     .status = 507,
     .title = "Insufficient storage",
     .detail = "The server's disk is full. The request changed nothing; stored data are safe."},
    {.code = "store-held",
     .status = 503,
     .title = "Busy",
     .detail = "Another program uses the store; send the request again."},
    {.code = "store-not-writable",
     .status = 503,
     .title = "The store cannot be written",
     .detail = "The server cannot write to its disk, or does not reach its database. The request changed "
               "nothing; tell the operator."},
    {.code = "store-damaged",
     .status = 503,
     .title = "The store is damaged",
     .detail = "The requested data are damaged in the server's store and cannot be read; the rest can. The "
               "operator lists the damage with floeplan verify, saves the rest with floeplan repair, or "
               "restores a backup."},
    {.code = "entry-damaged",
     .status = 503,
     .title = "The store is damaged",
     .detail = "This {kind} is damaged in the server's store and cannot be read; the list lacks it. The "
               "operator saves the rest with floeplan repair, or restores a backup.",
     .slots = {{{"kind", "plan"}}},
     .type = "store-damaged"},
    {.code = "internal-error",
     .status = 500,
     .title = "Internal error",
     .detail = "The server could not answer; its log says why. You may send the request again."},
});

consteval const ProblemKind& problem_kind(std::string_view code) {
  for (const ProblemKind& kind : problem_kinds)
    if (kind.code == code) return kind;
  throw std::logic_error{"no problem has this code"};
}

/// The problem with these values in its detail.
[[nodiscard]] Problem problem_of(const ProblemKind& kind, std::vector<messages::Value> values);

/// The problem with this code; its values are given in the catalogue's order. An unknown code or other values
/// do not compile.
template <messages::Code code, class... Given>
[[nodiscard]] Problem problem(const Given&... given) {
  constexpr const ProblemKind& kind = problem_kind(code.view());
  static_assert(messages::takes<std::decay_t<Given>...>(kind.words()),
                "these are not the values that the catalogue names");
  return problem_of(kind, {messages::value_from(given)...});
}

}  // namespace floeplan::problems
