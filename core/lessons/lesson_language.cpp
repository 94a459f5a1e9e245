#include "core/lessons/lesson_language.h"

#include <algorithm>
#include <map>
#include <regex>

namespace feedscope {
namespace {

constexpr const char* french = "fr";
constexpr const char* no_break_space = "\u00a0";

/// Causes and models as in resources/translations/feedscope_fr.ts, which the core cannot read.
const std::map<std::string, std::string>& french_words() {
  static const std::map<std::string, std::string> words{
      // Headings
      {"Question", "Question"},
      {"Hint", "Indice"},
      {"*Hint:* {}", "*Indice\u00a0:* {}"},
      {"Answers", "Réponses"},
      {"Sources", "Sources"},
      {"Set", "Régler"},
      {"First set", "Régler d’abord"},
      {"Move", "Modifier"},
      {"Watch", "Observer"},
      {"Begins with", "Au départ\u00a0:"},
      {"minutes", "minutes"},
      {"About {} minutes.", "Environ {} minutes."},
      {"{}: {}", "{}\u00a0: {}"},
      {"{}: from {} to {}", "{}\u00a0: de {} à {}"},
      {", ", "\u00a0; "},
      {"; ", "\u00a0; "},
      {"Program", "Programme"},
      {"Machine", "Machine"},
      {"Control model", "Modèle de commande"},
      {"Setting", "Réglage"},
      {"page %1 of %2", "page %1 sur %2"},
      {"Programmed and executed path of {}.", "Trajectoires programmée et exécutée ({})."},
      {"Feed with its limiting causes, acceleration and jerk of {}.",
       "Avance et ses causes de limitation, accélération et jerk ({})."},
      {"Every number of the simulation on these pages was simulated by Feedscope when they were made.",
       "Toutes les valeurs simulées de ces pages ont été calculées par Feedscope à leur création."},
      {"For learners", "Pour les apprenants"},
      {"For the teacher", "Pour l’enseignant"},
      {"What the answers build on", "Sur quoi reposent les réponses"},
      {"Expected", "Attendu"},
      {"Computed", "Calculé"},
      {"does not hold", "non vérifié"},
      {"Answer", "Réponse"},
      {"Before anything is changed: {}.", "Avant toute modification\u00a0: {}."},
      {"Where to look: {}.", "Où regarder\u00a0: {}."},
      {"What limits the feed along the path: {}.",
       "Ce qui limite l’avance le long de la trajectoire\u00a0: {}."},
      {"my value:", "ma valeur\u00a0:"},
      {"Before you look", "Avant de regarder"},
      {"On my control", "Sur ma commande"},
      {"Path of {}.", "Trajectoire ({})."},
      // Lists
      {"Half a day, {} minutes: lessons {}", "Une demi-journée, {} minutes\u00a0: leçons {}"},
      {"Two days: all, with own programs after 4, 8 and 12",
       "Deux jours\u00a0: toutes, avec des programmes personnels après 4, 8 et 12"},
      {"half day", "demi-journée"},
      // Claims
      {"as the lesson begins", "au départ de la leçon"},
      {"with {}", "avec {}"},
      {"that {}", "la valeur {}"},
      {"{}, over that {}", "{}, divisé par la valeur {}"},
      {"{}, less that {}", "{}, moins la valeur {}"},
      {"{}, in percent more than that {}", "{}, en pour cent de plus que la valeur {}"},
      {"{}, in percent less than that {}", "{}, en pour cent de moins que la valeur {}"},
      {"less than {}", "inférieur à {}"},
      {"more than {}", "supérieur à {}"},
      {"about {}, within {}", "environ {}, à {} près"},
      {"between {} and {}", "entre {} et {}"},
      // Measures
      {"cycle time", "temps de cycle"},
      {"programmed time", "temps programmé"},
      {"cycle time over programmed time", "rapport du temps de cycle au temps programmé"},
      {"mean feed", "avance moyenne"},
      {"largest feed", "avance maximale"},
      {"least feed", "avance minimale"},
      {"feed in the corner at the end", "avance dans l’angle en fin de bloc"},
      {"contour error", "erreur de contour"},
      {"path length", "longueur de trajectoire"},
      {"corner blends", "raccords d’angle"},
      {"largest velocity", "vitesse maximale"},
      {"largest acceleration", "accélération maximale"},
      {"largest jerk", "jerk maximal"},
      {"largest following error", "écart de poursuite maximal"},
      {"largest contour error of the actual path", "erreur de contour maximale de la trajectoire réelle"},
      {"largest chip thickness", "épaisseur de copeau maximale"},
      {"least chip thickness", "épaisseur de copeau minimale"},
      {"largest peak cutting force", "effort de coupe de crête maximal"},
      {"time below the least chip", "temps sous l’épaisseur de copeau minimale"},
      {"share of the cutting time below the least chip",
       "part du temps de coupe sous l’épaisseur de copeau minimale"},
      {"largest tangential acceleration", "accélération tangentielle maximale"},
      {"largest acceleration across the path", "accélération maximale normale à la trajectoire"},
      {"largest tangential jerk", "jerk tangentiel maximal"},
      {"time", "temps"},
      {"share of the cycle time", "part du temps de cycle"},
      {"{} limited by {}", "{} limité par\u00a0: {}"},
      {"{} of an axis", "{} d’un axe"},
      {"{} of axis {}", "{} de l’axe {}"},
      {"{}, line {}", "{}, ligne {}"},
      {"{}, lines {} to {}", "{}, lignes {} à {}"},
      // Causes
      {"programmed feed", "avance programmée"},
      {"rapid traverse", "déplacement rapide"},
      {"axis velocity", "vitesse d’un axe"},
      {"axis acceleration", "accélération d’un axe"},
      {"axis jerk", "jerk d’un axe"},
      {"radial acceleration", "accélération radiale"},
      {"radial jerk", "jerk radial"},
      {"velocity on a blend", "vitesse sur un raccord"},
      {"radial acceleration on a blend", "accélération radiale sur un raccord"},
      {"radial jerk on a blend", "jerk radial sur un raccord"},
      {"tangential acceleration on a blend", "accélération tangentielle sur un raccord"},
      {"tangential jerk on a blend", "jerk tangentiel sur un raccord"},
      {"curvilinear jerk", "jerk curviligne"},
      {"jerk at a change of curvature", "jerk à un changement de courbure"},
      {"velocity of axis %1", "vitesse de l’axe %1"},
      {"acceleration of axis %1", "accélération de l’axe %1"},
      {"jerk of axis %1", "jerk de l’axe %1"},
      {"radial acceleration of axis %1", "accélération radiale de l’axe %1"},
      {"radial jerk of axis %1", "jerk radial de l’axe %1"},
      {"velocity of axis %1 on a blend", "vitesse de l’axe %1 sur un raccord"},
      {"radial acceleration of axis %1 on a blend", "accélération radiale de l’axe %1 sur un raccord"},
      {"radial jerk of axis %1 on a blend", "jerk radial de l’axe %1 sur un raccord"},
      {"tangential acceleration of axis %1 on a blend",
       "accélération tangentielle de l’axe %1 sur un raccord"},
      {"tangential jerk of axis %1 on a blend", "jerk tangentiel de l’axe %1 sur un raccord"},
      {"jerk of axis %1 at a change of curvature", "jerk de l’axe %1 à un changement de courbure"},
      {"interpolation period", "période d’interpolation"},
      {"block time", "temps de bloc"},
      {"contour tolerance", "tolérance de contour"},
      {"look-ahead horizon", "horizon d’anticipation"},
      {"velocity filters", "filtres de vitesse"},
      {"indexing of rotary axes", "positionnement des axes rotatifs"},
      {"indexing of axis %1", "positionnement de l’axe %1"},
      {"swing about the tip", "pivotement autour de la pointe"},
      {"swing about the tip, held by axis %1", "pivotement autour de la pointe, retenu par l’axe %1"},
      {"junction deviation", "écart de jonction (junction deviation)"},
      {"square corner velocity", "vitesse dans un angle de 90° (square corner velocity)"},
      {"minimum cruise ratio", "part minimale à vitesse constante"},
      {"kink between blocks", "cassure entre blocs"},
      {"velocity along the path", "vitesse le long de la trajectoire"},
      {"acceleration along the path", "accélération le long de la trajectoire"},
      {"braking for a slower place ahead", "ralentissement pour la suite"},
      {"exact stop", "arrêt précis"},
      {"dwell", "temporisation"},
      {"tool change", "changement d’outil"},
      {"spindle start", "démarrage de la broche"},
      // Models
      {"CAM baseline", "Référence FAO"},
      {"Local smoothing by cubic blends (Sinumerik 840D)",
       "Lissage local par raccords cubiques (Sinumerik 840D)"},
      {"Circular-arc blends at constant speed", "Raccords en arc de cercle à vitesse constante"},
      {"Circular interpolation (Sinumerik 840D)", "Interpolation circulaire (Sinumerik 840D)"},
      {"Connecting arcs, static and dynamic look-ahead (Sinumerik 840D, TNC 430)",
       "Arcs de raccord, anticipation statique et dynamique (Sinumerik 840D, TNC 430)"},
      {"Velocity pulses through FIR filters (Heidenhain TNC 640)",
       "Impulsions de vitesse et filtres RIF (Heidenhain TNC 640)"},
      {"Time-optimal bound", "Borne en temps optimal"},
      {"Open control grbl", "Commande ouverte grbl"},
      {"Open control Klipper", "Commande ouverte Klipper"},
      {"Open control LinuxCNC", "Commande ouverte LinuxCNC"},
  };
  return words;
}

}  // namespace

const std::vector<std::string>& lesson_languages() {
  static const std::vector<std::string> codes{"en", french};
  return codes;
}

std::string lesson_word(const std::string& english, const std::string& language) {
  if (language != french) {
    return english;
  }
  const auto found = french_words().find(english);
  return found == french_words().end() ? english : found->second;
}

std::string number_in(std::string number, const std::string& language) {
  if (language == french) {
    std::ranges::replace(number, '.', ',');
  }
  return number;
}

std::string number_with_unit(const std::string& number, const std::string& unit,
                             const std::string& language) {
  if (unit.empty() || unit == "°") {
    return number_in(number, language) + unit;
  }
  return number_in(number, language) + (language == french ? no_break_space : " ") + unit;
}

std::string plain_number(const std::string& typed, const std::string& language) {
  if (language != french) {
    return typed;
  }
  if (const auto points = std::ranges::count(typed, '.'); points > 0) {
    return points > 1 ? typed : "";  // several points: the number of a section
  }
  std::string plain = typed;
  std::ranges::replace(plain, ',', '.');
  return plain;
}

std::string with_no_break_spaces(const std::string& text, const std::string& language) {
  if (language != french) {
    return text;
  }
  static const std::regex before_mark(R"(([^ \n]) (?=[:;?!%]|»))");
  static const std::regex after_quote("« ");
  static const std::regex before_unit(R"((\d) (?=m/|(?:mm|µm|ms|min|s)(?!\w)))");
  std::string result = std::regex_replace(text, before_mark, std::string("$1") + no_break_space);
  result = std::regex_replace(result, after_quote, std::string("«") + no_break_space);
  return std::regex_replace(result, before_unit, std::string("$1") + no_break_space);
}

}  // namespace feedscope
