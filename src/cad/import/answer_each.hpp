#pragma once
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "cad/import/guard.hpp"
#include "cad/import/messages.hpp"
#include "cad/import/read_file.hpp"
#include "cad/part/importer_process.hpp"

namespace reye::cad {

/// The mesh that `make` gives, or why there is none: an Answer of both.
template <class Answer, class Make>
Answer mesh_or_failure(Make make) {
  try {
    return Answer{make(), {}};
  } catch (const std::bad_alloc&) {
    return Answer{{}, "meshing it takes more than " + std::to_string(meshing_GB) + " GB of memory"};
  } catch (const std::exception& error) {
    return Answer{{}, error.what()};
  } catch (...) {
    return Answer{{}, "gmsh fails without a message"};
  }
}

/// Answers each request with the bytes that `make` gives for it, limited to what meshing may take. Signals that a
/// terminal or a queue sends to all processes of a run are for the program that asks.
template <class Make>
void answer_each(const Reading& how, Make make) {
  ignore_ends_of_groups();
  if (!how.trusted) limit_memory(meshing_GB);
  while (const auto request = next_request()) {
    if (!how.trusted) limit_computing(meshing_s);
    say(make(*request));
  }
}

}  // namespace reye::cad
