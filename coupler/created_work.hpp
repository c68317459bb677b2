// What the work that the coupling scheme creates or destroys means for a run.
#pragma once

#include <string>

#include "proto/case.pb.h"

namespace cosurge {

/// A remark on the energy `created` by the coupling [J] (negative: taken away), where the absolute work of
/// all windows is `passed` [J]; empty where it is small, or where every structure is rigid, whose motion does
/// not depend on the load.
std::string created_work_remark(const v1::Case& the_case, double created, double passed);

}  // namespace cosurge
