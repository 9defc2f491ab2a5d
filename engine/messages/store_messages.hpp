#pragma once

#include <string>

#include "engine/messages/kind.hpp"
#include "engine/messages/sentence.hpp"

/// Why the store does not do what it is asked: its database, its folder, the disk, another program. Whoever runs the program
/// reads them on the command line and in the server's log; clients get a problem instead (`api/problems`).
/// Ranks    none is a danger: a plan that cannot be read or stored is not flown
namespace floeplan::messages {

inline constexpr auto store_kinds = std::to_array<Kind>({
    // The database and the disk below it. {detail}: the words of the database's library.
    {.code = "database-damaged",
     .text = "the database {file} is damaged or not a Floeplan store ({detail})",
     .hint = "floeplan verify lists the damage, floeplan repair saves the rest, floeplan restore puts back a "
             "backup",
     .slots = {{{"file", "/data/floeplan.db"}, {"detail", "database disk image is malformed"}}}},
    {.code = "disk-full",
     .text = "the database {file} cannot grow: the disk is full ({detail})",
     .hint = "free some space and try again",
     .slots = {{{"file", "/data/floeplan.db"}, {"detail", "database or disk is full"}}}},
    {.code = "database-locked",
     .text = "another program kept the database {file} locked for too long ({detail})",
     .hint = "try again when that program is done",
     .slots = {{{"file", "/data/floeplan.db"}, {"detail", "database is locked"}}}},
    {.code = "disk-failed",
     .text = "the database {file} cannot be read or written ({detail})",
     .hint = "check the disk",
     .slots = {{{"file", "/data/floeplan.db"}, {"detail", "disk I/O error"}}}},
    {.code = "database-read-only",
     .text = "the database {file} cannot be written ({detail})",
     .hint = "check its permissions",
     .slots = {{{"file", "/data/floeplan.db"}, {"detail", "attempt to write a readonly database"}}}},
    {.code = "database-not-opened",
     .text = "the database {file} cannot be opened ({detail})",
     .hint = "check its permissions",
     .slots = {{{"file", "/data/floeplan.db"}, {"detail", "unable to open database file"}}}},
    {.code = "database-failed",
     .text = "the database {file} failed ({detail})",
     .slots = {{{"file", "/data/floeplan.db"}, {"detail", "constraint failed"}}}},
    {.code = "file-not-flushed",
     .text = "{file} cannot be written to the disk",
     .hint = "check the disk and its free space",
     .slots = {{{"file", "/data/floeplan.db"}}}},
    {.code = "database-not-read", .text = "the database cannot be read", .hint = "check the disk"},
    {.code = "database-without-checksums", .text = "the database lies in no file with checksums"},
    {.code = "no-checksums",
     .text = "the database {file} cannot get checksums",
     .slots = {{{"file", "/data/floeplan.db"}}}},
    {.code = "no-database-version", .text = "the database does not tell its version"},
    {.code = "upload-not-written", .text = "the upload cannot be written to the disk"},

    // The folder of the store.
    {.code = "store-folder-not-made",
     .text = "the folder {folder} cannot be created: {why}",
     .slots = {{{"folder", "/data"}, {"why", "Permission denied"}}}},
    {.code = "store-folder-read-only",
     .text = "the folder {folder} cannot be written ({why})",
     .hint = "check its permissions",
     .slots = {{{"folder", "/data"}, {"why", "Permission denied"}}}},
    {.code = "folder-without-locks",
     .text = "{folder} lies on a file system without locks ({why})",
     .hint = "choose a folder on a local disk",
     .slots = {{{"folder", "/data"}, {"why", "Function not implemented"}}}},
    {.code = "folder-without-shared-memory",
     .text = "{file} lies on a file system that cannot share memory between programs",
     .hint = "choose a folder on a local disk",
     .slots = {{{"file", "/data/floeplan.db"}}}},
    {.code = "database-of-another-program",
     .text = "{file} belongs to another program, not to Floeplan",
     .hint = "choose another folder",
     .slots = {{{"file", "/data/floeplan.db"}}}},
    {.code = "database-gone",
     .text = "the folder {folder} held a store, but its {file} is gone",
     .hint = "put it back, for example with floeplan restore FILE, or choose an empty folder",
     .slots = {{{"folder", "/data"}, {"file", "floeplan.db"}}}},

    // Other programs at the same store.
    {.code = "store-in-use",
     .text = "the store {folder} is in use",
     .hint = "stop the programs that use it first",
     .slots = {{{"folder", "/data"}}}},
    {.code = "store-being-replaced",
     .text = "the store {folder} is being restored, repaired or brought up to date",
     .hint = "try again when that is done",
     .slots = {{{"folder", "/data"}}}},
    {.code = "database-in-use",
     .text = "{file} is in use by another program",
     .hint = "stop it first",
     .slots = {{{"file", "/data/floeplan.db"}}}},
    {.code = "store-served",
     .text = "the store {folder} is in use by {holder}",
     .hint = "stop that server first, or choose another folder with --data",
     .slots = {{{"folder", "/data"}, {"holder", "process 4711"}}}},
    {.code = "store-newer",
     .text = "a newer Floeplan wrote the store (its schema is {schema}; this program knows {known})",
     .hint = "update the program, or choose another folder",
     .slots = {{{"schema", 32}, {"known", 31}}}},

    // Backups, repairs and new versions.
    {.code = "header-damaged",
     .text = "the header of {file} is damaged",
     .hint = "put back a backup with floeplan restore FILE",
     .slots = {{{"file", "/data/floeplan.db"}}}},
    {.code = "entry-lost",
     .text = "{entry} of {file} is damaged; nothing was changed",
     .hint = "floeplan repair saves the undamaged part",
     .slots = {{{"entry", "the plan p0123456789ab"}, {"file", "/data/floeplan.db"}}}},
    {.code = "references-broken",
     .text = "the store is damaged: it refers to a dataset that it does not hold",
     .hint = "put back a backup with floeplan restore FILE"},
    {.code = "not-set-aside",
     .text = "the damaged database cannot be set aside ({why})",
     .slots = {{{"why", "rename: Permission denied"}}}},
    {.code = "not-put-in-place",
     .text = "the new database cannot be put in its place ({why}); the store is unchanged",
     .slots = {{{"why", "rename: Permission denied"}}}},
    {.code = "backup-exists",
     .text = "{file} exists already",
     .hint = "name a new file",
     .slots = {{{"file", "/backup/floeplan.db"}}}},
    {.code = "backup-not-sound",
     .text = "the copy is damaged ({damage}): the store or the disk is",
     .slots = {{{"damage", "page 17 has changed"}}}},
    {.code = "backup-refused",
     .text = "{file} cannot be restored; {why}",
     .hint = "take another backup",
     .slots = {{{"file", "/backup/floeplan.db"}, {"why", "it is no store of Floeplan"}}}},

    // What is stored.
    {.code = "stored-data-damaged",
     .text = "stored data are damaged ({why})",
     .hint = "remove the dataset and ingest its file again, or restore the store from a backup",
     .slots = {{{"why", "a cell of a mesh has a corner that is no point"}}}},
    {.code = "stored-polygon-damaged",
     .text = "a stored polygon is damaged",
     .hint = "remove its dataset and ingest the file again, or restore the store from a backup"},
    {.code = "stored-word-unknown",
     .text = "the store holds {what} that this program does not know: {word}",
     .hint = "update the program",
     .slots = {{{"what", "a constituent of a tide"}, {"word", "m13"}}}},
    {.code = "stored-plan-unreadable",
     .text = "a stored plan cannot be read: {why}",
     .hint = "plan again",
     .slots = {{{"why", "a leg has an unknown propulsion"}}}},
    {.code = "data-removed-meanwhile",
     .text = "the data were removed while they arrived",
     .hint = "ingest the files again"},
    {.code = "data-of-another-form",
     .text = "the data that arrived have tables of another form",
     .hint = "ingest the files again"},
});

/// The message of this code in one sentence, for an error that carries it; it is told its values in the order of the
/// catalogue.
template <Code code, class... Given>
[[nodiscard]] std::string store_text(const Given&... given) {
  return whole_text(make_message<store_kinds, code>(given...));
}

}  // namespace floeplan::messages
