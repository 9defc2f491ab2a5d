#include <string>

#include "storage/ingest/process/reader_main.hpp"

/// The part of the program that reads foreign files, alone: `reader read-files STAGING [FILE...]`.
int main(int argc, char** argv) {
  if (argc < 3 || std::string{argv[1]} != "read-files") return 2;
  return floeplan::ingest::read_foreign_files(argv[2], {argv + 3, argv + argc});
}
