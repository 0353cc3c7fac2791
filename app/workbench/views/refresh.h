// Panels include the Refresh of the workbench from here.
#pragma once

#include "app/workbench/refresh.h"
