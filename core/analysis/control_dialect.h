#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/machine/machine.h"
#include "core/program/dialect.h"

namespace feedscope {

/// The shipped machine for a program in `dialect` where nobody names one: one whose control reads it, else
/// default_machine. Dialect::iso is what all controls share.
std::string default_machine_of(Dialect dialect);

/// Whether a machine's control, by its name in the machine file, reads programs in `dialect`; none where the
/// name is not known, or the dialect is Dialect::iso.
std::optional<bool> control_reads(const Machine& machine, Dialect dialect);

/// A program on a machine whose control does not read it.
struct ControlMismatch {
  Dialect dialect = Dialect::iso;
  std::string machine;          ///< name
  std::string control;          ///< of that machine
  std::string fitting_machine;  ///< id of a shipped one whose control reads the program; empty: there is none
};

std::optional<ControlMismatch> control_mismatch(const Machine& machine, Dialect dialect);

/// "The program is written for Heidenhain, but Spinner MVC 850 has a Siemens Sinumerik 840D. ..."
Message describe(const ControlMismatch& mismatch);

}  // namespace feedscope
