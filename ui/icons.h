/// The few icons that we use, as UTF-8 of Font Awesome 4.7 (Debian's fonts-font-awesome), merged into every font.
#pragma once

namespace trocar::ui::icon {

constexpr const char* kRecord = "\xef\x84\x91";     // f111 circle
constexpr const char* kPlay = "\xef\x81\x8b";       // f04b
constexpr const char* kPause = "\xef\x81\x8c";      // f04c
constexpr const char* kStop = "\xef\x81\x8d";       // f04d
constexpr const char* kToBegin = "\xef\x81\x88";    // f048 step-backward
constexpr const char* kToEnd = "\xef\x81\x91";      // f051 step-forward
constexpr const char* kUndo = "\xef\x83\xa2";       // f0e2
constexpr const char* kRedo = "\xef\x80\x9e";       // f01e
constexpr const char* kCut = "\xef\x83\x84";        // f0c4 scissors
constexpr const char* kPaste = "\xef\x83\xaa";      // f0ea
constexpr const char* kEject = "\xef\x81\x92";      // f052
constexpr const char* kLoop = "\xef\x81\xb9";       // f079 retweet
constexpr const char* kMagnet = "\xef\x81\xb6";     // f076
constexpr const char* kTrash = "\xef\x87\xb8";      // f1f8
constexpr const char* kVerify = "\xef\x80\x8c";     // f00c check
constexpr const char* kCross = "\xef\x80\x8d";      // f00d
constexpr const char* kTrain = "\xef\x86\x9d";      // f19d graduation cap
constexpr const char* kField = "\xef\x82\x84";      // f084
constexpr const char* kCube = "\xef\x86\xb2";       // f1b2
constexpr const char* kCubes = "\xef\x86\xb3";      // f1b3
constexpr const char* kFilm = "\xef\x80\x88";       // f008
constexpr const char* kFolder = "\xef\x81\xbc";     // f07c folder open
constexpr const char* kFile = "\xef\x80\x96";       // f016
constexpr const char* kWarning = "\xef\x81\xb1";    // f071
constexpr const char* kHelp = "\xef\x81\x99";       // f059 question in a circle
constexpr const char* kInfo = "\xef\x81\x9a";       // f05a
constexpr const char* kSearch = "\xef\x80\x82";     // f002
constexpr const char* kHistory = "\xef\x87\x9a";    // f1da
constexpr const char* kTasks = "\xef\x82\xae";      // f0ae
constexpr const char* kBars = "\xef\x83\x89";       // f0c9 three bars
constexpr const char* kList = "\xef\x80\xba";       // f03a
constexpr const char* kCopy = "\xef\x83\x85";       // f0c5
constexpr const char* kCamera = "\xef\x80\xb0";     // f030
constexpr const char* kClock = "\xef\x80\x97";      // f017
constexpr const char* kRoad = "\xef\x80\x98";       // f018
constexpr const char* kGhost = "\xef\x86\xbb";      // f1bb
constexpr const char* kCrosshair = "\xef\x81\x9b";  // f05b
constexpr const char* kSpinner = "\xef\x84\x90";    // f110
constexpr const char* kSliders = "\xef\x87\x9e";    // f1de
constexpr const char* kRefresh = "\xef\x80\xa1";    // f021
constexpr const char* kKeyboard = "\xef\x84\x9c";   // f11c
constexpr const char* kTable = "\xef\x83\x8e";      // f0ce
constexpr const char* kArrowUp = "\xef\x81\xa2";    // f062
constexpr const char* kArrowDown = "\xef\x81\xa3";  // f063
constexpr const char* kArrows = "\xef\x81\x87";     // f047 arrows to four sides
constexpr const char* kStar = "\xef\x80\x85";       // f005
constexpr const char* kPlus = "\xef\x81\xa7";       // f067
constexpr const char* kEye = "\xef\x81\xae";        // f06e
constexpr const char* kChip = "\xef\x8b\x9b";       // f2db microchip
constexpr const char* kBranch = "\xef\x84\xa6";     // f126 code-fork
constexpr const char* kThLarge = "\xef\x80\x89";    // f009
constexpr const char* kChart = "\xef\x82\x80";      // f080 bar chart
constexpr const char* kBook = "\xef\x80\xad";       // f02d
constexpr const char* kAdjust = "\xef\x81\x82";     // f042
constexpr const char* kDownload = "\xef\x80\x99";   // f019
constexpr const char* kPencil = "\xef\x81\x80";     // f040
constexpr const char* kExpand = "\xef\x81\xa5";     // f065
constexpr const char* kBalance = "\xef\x89\x8e";    // f24e
constexpr const char* kUsers = "\xef\x83\x80";      // f0c0

}  // namespace trocar::ui::icon
