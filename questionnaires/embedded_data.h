// The data files of this folder, embedded in the programs (cmake/TactusEmbed.cmake).
#pragma once

#include <string_view>

namespace tactus::questionnaires {

std::string_view aliasesJson();                             ///< forms/aliases.json
std::string_view usabilityFormJson();                       ///< forms/usability_v1.json
std::string_view usabilityAnyJson();                        ///< forms/usability_any.json
std::string_view usabilityGermanWordingJson();              ///< forms/usability_v1.de.json
std::string_view usabilityTraditionalChineseWordingJson();  ///< forms/usability_v1.zh-Hant.json
std::string_view usabilitySimplifiedChineseWordingJson();   ///< forms/usability_v1.zh-Hans.json
std::string_view table3Csv();                               ///< published/table_3.csv
std::string_view tableA2Csv();                              ///< published/table_a2.csv
std::string_view tableA2ReadingsJson();                     ///< published/table_a2_readings.json

}  // namespace tactus::questionnaires
