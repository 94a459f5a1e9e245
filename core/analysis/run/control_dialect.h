#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/machine/machine.h"
#include "core/program/dialect.h"

namespace feedscope {

/// Shipped machine for a program in `dialect` if none is named: one whose control reads the dialect, else
/// default_machine. Dialect::iso is common to all controls.
std::string default_machine_of(Dialect dialect);

/// Whether a machine's control, by its name in the machine file, reads programs in `dialect`; none for an
/// unknown control or Dialect::iso.
std::optional<bool> control_reads(const Machine& machine, Dialect dialect);

/// A program on a machine whose control does not read it.
struct ControlMismatch {
  Dialect dialect = Dialect::iso;
  std::string machine;          ///< name
  std::string control;          ///< of that machine
  std::string fitting_machine;  ///< id of a shipped one whose control reads the program; empty without one
};

std::optional<ControlMismatch> control_mismatch(const Machine& machine, Dialect dialect);

/// Message such as "The program is written for Heidenhain, but Spinner MVC 850 has a Siemens Sinumerik 840D.
/// ..."
Message describe(const ControlMismatch& mismatch);

}  // namespace feedscope
