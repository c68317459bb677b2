#include "coupler/created_work.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "coupler/interface_account.hpp"

namespace cosurge {
namespace {

bool only_rigid(const v1::Case& the_case) {
  const auto rigid = [](const v1::Solid& solid) { return solid.model() == v1::SolidModel::rigid; };
  if (the_case.solids().empty()) return rigid(the_case.solid());
  return std::all_of(the_case.solids().begin(), the_case.solids().end(), rigid);
}

}  // namespace

std::string created_work_remark(const v1::Case& the_case, double created, double passed) {
  if (only_rigid(the_case) || !(passed > 0)) return "";
  const double share = created / passed;
  if (share > InterfaceAccount::much)
    return fmt::format(
        "the coupling created {:.2g} J of spurious energy ({:.3g} % of the work done, limit {:.0f} %)",
        created, 100 * share, 100 * InterfaceAccount::much);
  if (share < -InterfaceAccount::much_taken)
    return fmt::format(
        "the coupling took {:.2g} J of energy away ({:.3g} % of the work done, limit {:.0f} %)", -created,
        -100 * share, 100 * InterfaceAccount::much_taken);
  return "";
}

}  // namespace cosurge
