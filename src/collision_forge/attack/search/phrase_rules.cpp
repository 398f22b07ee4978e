#include "collision_forge/attack/search/phrase_rules.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

#define EGO "(?:our|the ego's|ego's|the ego vehicle's|my|ego|the)"
#define US "(?:us|we|the ego|ego|ego vehicle|the ego vehicle|our car|our vehicle|me)"
#define ROAD "(?:road|street|lane|carriageway|roadway)"
#define SIDE "(left|right)(?: hand)?"

// The order matters: longer and more specific phrases precede their parts.
const std::vector<PhraseRule> kFixedRules = {
    {"(?:from )?behind (?:(?:a|an|the|two|some) )?(?:parked|standing|stationary|stopped) "
     "(?:cars?|vans?|vehicles?)",
     "hidden_by=parked_vehicle"},
    {"(?:at )?(?:the )?(?:end|tail) of (?:a |the )?(?:traffic )?queue|(?:two|2) "
     "(?:stopped|stationary|standing) (?:cars|vehicles)",
     "queue=true manoeuvre=lead_stopped"},
    {"(?:pedestrian|adult|person)(?= runs? (?:across|out|(?:in|on)to the " ROAD "))",
     "attacker_class=runner"},
    // Would be read as road users, vehicles behind or ahead, or signs.
    {"(?:from )?behind (?:(?:a|an|the|two|some) )?"
     "(?:(?:large|small|parked|standing|stationary|stopped) "
     ")*(?:cars?|vans?|trucks?|bus|vehicles?|obstacles?|obstruction)",
     "ignored"},
    {"car to(?= (?:car|pedestrian|cyclist|bicycl|motor))", ""},
    {"(?:fails? to stop|does not stop|doesn't stop) (?:at|for) (?:a |the )?(?:red "
     "light|red|lights?|stop sign|sign)",
     "manoeuvre=straight_crossing"},
    // Ends with a word that also precedes times.
    {"cut ?ins?|cuts? (?:us off|in front(?: of " US
     ")?|in)|cutting (?:in(?: front)?|us off)|squeezes in|moves over into|swerves? in(?:to)? front",
     "manoeuvre=cut_in"},
    // Quantities with the words that name their field.
    {"(?:ego|we|ego vehicle)(?: is| are)?(?: drives?| driving| going| travell?ing| doing)? ?(?:at "
     ")?{v}",
     "ignored"},
    {"(?:lateral|laterally)(?: speed| velocity)?(?: of| at| is)? {v}", "lateral_speed"},
    {"(?:at )?{v}(?: of)? (?:lateral|laterally|sideways)(?: speed| velocity)?", "lateral_speed"},
    {"(?:at |with )?(?:a )?{v} (?:closing|relative|impact|difference|speed difference)(?: speed| "
     "velocity)?",
     "impact_speed"},
    {"(?:closing in|closing|closes? in|closes?|relative|approach|impact|crash|collision)(?: speed| "
     "velocity)?(?: of| at| is)? {v}",
     "impact_speed"},
    {"(?:speed difference|difference in speed|delta ?v)(?: of| is)? {v}", "impact_speed"},
    {"(?:going |driving )?{v} (?:slower|less)(?: than " US ")?", "impact_speed pace=slow"},
    {"(?:going |driving )?{v} faster(?: than " US ")?", "impact_speed pace=fast"},
    {"(?:ego|we) (?:hits?|strikes?) [a-z ]{0,40}?(?:at|with) {v}", "impact_speed keep=hit"},
    {"(?:headway|time gap|time headway)(?: of| is)? {t}", "headway"},
    {"(?:a )?{t} (?:headway|time gap|time headway|behind|ahead)", "headway"},
    {"(?:at )?(?:a )?(?:gap|(?:following )?distance)(?: of| is)? {l}", "gap"},
    {"(?:a )?{l}(?: of)? (?:gap|ahead|away|distance|in front(?: of " US ")?)", "gap"},
    {"{l}", "gap"},
    {"(?:(?:with )?(?:a )?deceleration(?: of| at| with| is)?|at|with) {a}", "deceleration"},
    {"{a}", "deceleration"},
    {"(?:impact location|impact point|impact position|point of impact|impact|hit)(?: of| at| is)? "
     "{p}(?: of " EGO " (?:vehicle )?(?:width|front))?",
     "impact_location"},
    {"(?:at )?{p} (?:impact location|impact point|impact position)", "impact_location"},
    {"(?:at )?{p} of " EGO " ?(?:vehicle )?(?:width|front)", "impact_location"},
    {"(?:at )?{p} of vehicle width", "impact_location"},
    {"(?:with )?(?:an )?overlap(?: of| is)? {p}", "overlap"},
    {"(?:with )?(?:a )?{p} (?:of )?(?:frontal )?overlap", "overlap"},
    {"(?:(?:travell?ing|driving|going|riding|doing|moving|(?:attacker )?speed(?: of)?|at|with|is) "
     ")*{v}",
     "attacker_speed"},
    {"(?:(?:in|after|within|tta|ttc|time to "
     "(?:attack|collision|contact|impact|crash|accident)|of|is|a|at|contact|collision) )*{t}(?: "
     "(?:from now|after t0|from t0|later))*",
     "tta"},
    {"seed (N)", "seed="},
    {"(N) (?:alternatives?|variants?|versions?|variations?|different)", "alternatives="},
    // The ego's turn, and turns in front of it.
    {"(?:ego|we|ego vehicle) (?:(?:turns?|turning|is turning|makes a) left(?: turn)?|turns "
     "(?=across))(?: ?(?:across|in front of|into)(?: the)?(?: path of)?)?",
     "type=ltap turning=ego"},
    {"(?:our|ego's|the ego's) left turn|left turn(?: crash| collision)? (?:where|while|with) "
     "(?:the )?(?:ego|we)(?: is| are)? turning",
     "type=ltap turning=ego"},
    {"(?:with )?(?:the )?ego turning|turning ego", "type=ltap turning=ego"},
    {"(?:where|when|while|as|into which) (?:the )?(?:ego|we) (?:turns?|is turning|are turning)(?: "
     "(?:left|right))?",
     "turning=ego"},
    {"left turn across (?:the )?path(?: of)?(?: opposite direction)?|ltap(?:[ /]od)?", "type=ltap"},
    {"(?:turns?|turning|makes a|making a) left(?: turn)?(?: cuts)?(?: (?:across|in front of)(?: "
     "(?:our|the ego's|ego's))?(?: (?:path|lane))?)?|unprotected left(?: turn)?|left turner",
     "manoeuvre=turn_across_path"},
    {"turns? across (?:the path of )?the (?:one|vehicle|car) beside it",
     "manoeuvre=same_direction_turn"},
    {"(?:cuts|turns?) across (?:our|the|the ego's) path(?: of)?", "manoeuvre=turn_across_path"},
    {"(?:beside|next to) us turns (?:left|right) across(?: our path)?|in the "
     "(?:next|adjacent|neighbouring) lane turns (?:left |right )?across|same direction turn",
     "manoeuvre=same_direction_turn"},
    {"(?:left |right )?(?:turns?|turning)(?: left| right| at an? (?:junction|intersection))? "
     "?(?:into|onto) (?:our|the ego's|ego's|the) (?:path|lane|road)|(?:left|right) turning|enters "
     "(?:our|the ego's) path|pulls into (?:our|the ego's) path|shoots out "
     "of|(?:comes|pulls|pulling) out of (?:a|the) side "
     "(?:road|street)|turn into path",
     "manoeuvre=turn_into_path"},
    // Vehicles ahead and behind.
    {"(?:is |are |get |gets )?(?:hit |struck )?from behind(?: by)?|rear impact",
     "manoeuvre=follower_closes ego_side=rear"},
    {"angled?(?: crash| collision)? ?,? same direction", "type=angle_same_direction"},
    {"angled?(?: crash| collision)?(?: with an)? ?,? (?:oncoming|opposite direction)",
     "type=angle_opposite_direction"},
    {"(?:slams?|slamming)(?: on)?(?: the)? brakes|(?:brakes?|braking) "
     "(?:hard|heavily|sharply|fully)|(?:emergency|hard|full|harsh) "
     "(?:brak(?:es|ing)|stop)|(?:suddenly|abruptly) (?:stops|brakes)|(?:stops|brakes) "
     "(?:suddenly|abruptly)",
     "manoeuvre=lead_brakes deceleration=hard"},
    {"does not brake|doesn't brake|fails to (?:stop|brake)|rear ended|rear ends "
     "us|tailgat(?:ing|er|es)|(?:the )?follow(?:er|ing)(?: vehicle)?(?: closes)?(?: in)?|(?:driver "
     ")?behind(?: us)?",
     "manoeuvre=follower_closes"},
    {"(?:runs|crashes|drives|slams) into (?:the back of us|our rear|us from behind)",
     "manoeuvre=follower_closes ego_side=rear"},
    {"we get", "ego_side=rear"},
    {"(?:stands|stopped|stationary|standing|broken down|stalled|halted|parked in (?:our|the) "
     "lane|stopped on the " ROAD "|at (?:a )?standstill|lead stopped)",
     "manoeuvre=lead_stopped"},
    {"(?:lead )?(?:brakes?|braking|decelerates?|decelerating) checks?|brake checks?",
     "manoeuvre=lead_brakes"},
    {"(?:brakes?|braking|decelerates?|decelerating|decelerat(?:ion|ed)|lead brakes)",
     "manoeuvre=lead_brakes"},
    {"(?:slow moving|slow|slower|slow driving|lead slow)", "pace=slow"},
    {"(?:ego|we) rear ends?", "type=rear_end ego_side=front"},
    {"rear end(?:s|ing)?(?: collision| crash)?|rear end", "type=rear_end"},
    {"(?:lead|leading|preceding|leader)(?: vehicle)?|in front(?! of)|ahead(?: of us| of the "
     "ego)?|in the same direction|same direction(?! crash)",
     "hint=rear_end"},
    {"(?:ego|we) runs? into|(?:ego|we) hits?(?: its side)?(?: with our front)?", "ego_side=front"},
    // Oncoming vehicles.
    {"(?:wrong way(?: driver| round)?|ghost driver|on the wrong side|against traffic|against the "
     "traffic)",
     "manoeuvre=wrong_way"},
    {"(?:comes?|coming)? "
     "?(?:drift(?:s|ing)?|slides?|strays?|straying|cross(?:es|ing)?|swerv(?:es|ing)|comes|coming|"
     "veer(?:s|ing)?) (?:over|across|into|over into)? ?(?:the )?(?:cent(?:re|er) ?line|oncoming "
     "lane)|(?:enters|crosses into|drifts into|comes into) our lane|drifts into oncoming "
     "traffic|centre line crossing",
     "manoeuvre=centre_line_crossing"},
    {"overtak(?:es|ing|er)(?: into oncoming traffic)?", "manoeuvre=overtaking"},
    {"passing another vehicle|passes another vehicle", "manoeuvre=overtaking"},
    {"in the (?:oncoming|opposite|opposing) lane", "hint=opposite_direction"},
    {"head on|frontal(?:ly)?(?: crash| collision)?", "type=opposite_direction"},
    {"on ?coming|opposing|opposite(?: direction)?", "hint=opposite_direction"},
    // Vehicles beside.
    {"side ?swip(?:e|es|ed|ing)|scrap(?:e|es|ing)|sideswipe same direction",
     "type=sideswipe_same_direction"},
    {"(?:(?:backs|backing|reverses|reversing)(?: (?:out|into|up|onto|of|from))*|back out(?: "
     "of)?)(?: ?(?:(?:a|the|our|its) )?"
     "(?:drive(?:way)?|parking (?:space|place|bay|lot|spot)|bay|car "
     "park|garage|yard|road|street|lane|path)\\b)*",
     "manoeuvre=back_out"},
    {"pull(?:s|ing)? (?:out|away|off)(?: (?:in front of|into|of|from the "
     "stop|from|onto))?|leav(?:es|ing) (?:a|the) (?:parking (?:space|place|bay|lot|spot)|parked "
     "position)|parking (?:space|bay|place|spot)|from the kerb",
     "manoeuvre=pull_out"},
    {"parked", "hint=lane_change"},
    {"merg(?:e|es|ing)", "manoeuvre=merge"},
    {"drift(?:s|ing)?", "manoeuvre=drift"},
    {"chang(?:e|es|ing) lanes?|lane chang(?:e|es|ing)(?: collision)?|swerves into our lane|lc",
     "type=lane_change"},
    // Crossings.
    {"junction crossing|jc", "type=junction_crossing"},
    {"(?:runs?|running|jumps?|jumping|ignor(?:es|ing)|misses|through|drives through) (?:a |the "
     ")?(?:red light|red|light|lights|stop sign|stop|give way sign|yield sign)|red light "
     "runner|(?:fails to|does not) (?:yield|give way)",
     "manoeuvre=straight_crossing"},
    {"cross traffic|straight crossing(?: paths?)?|perpendicular crossing|at right angles",
     "manoeuvre=straight_crossing"},
    {"(?:steps?|stepping|walks?|walking|runs?|running|dash(?:es|ing)|jumps?|rushes|emerges|"
     "emerging) (?:out|across|(?:on|in|on)to (?:the|our|the ego's) (?:" ROAD "|path))",
     "hint=junction_crossing"},
    {"cross(?:es|ing)?(?: (?:the|a|at the))?(?: (?:" ROAD
     "|junction|intersection))?(?: in front(?: of(?: the)? (?:car|us|ego))?)?|(?:shoots?|shooting) "
     "across(?: the)?(?: junction| intersection)?",
     "crosses hint=junction_crossing"},
    {"(?:ego|we) t bones?", "type=junction_crossing ego_side=front"},
    {"t bon(?:e|es|ed|ing)|broad ?side(?: collision)?|side impact", "type=junction_crossing"},
    {"(?:at |across )?(?:a |an |the )?(?:junction|intersection|crossroads?|t junction)(?: "
     "collision| crash)?",
     "hint=junction_crossing"},
    // Sides.
    {"(?:from )?(?:the )?(?:near ?side)", "from_side=right"},
    {"(?:from )?(?:the )?(?:far ?side|far side)", "from_side=left"},
    {"(?:middle|centre|center) of (?:our|the|the ego's|ego's) front", "impact_location=0.5"},
    {"left (?:front )?(?:edge|corner)(?: of " EGO " front)?", "impact_location=0"},
    {"right (?:front )?(?:edge|corner)(?: of " EGO " front)?", "impact_location=1"},
    {"(left|right) to (?:left|right)", "from_side="},
    {"(?:from|from side|on) (?:the |our |the ego's )?" SIDE "(?: side| lane| on ramp)?",
     "from_side="},
    {"(?:in|from)? ?(?:the )?(?:adjacent |next )?" SIDE " (?:lane|on ramp|ramp)", "from_side="},
    {"(?:hits?|hitting|strikes?|into|along|touches)? ?(?:our|my|the ego's|ego's) " SIDE
     "(?: side| flank| door)?|ego side (left|right)",
     "ego_side="},
    {"(?:into |hits? )?(?:our |the )?driver's (?:side|door)", "ego_side=left"},
    {"(?:into |hits? )?(?:our |the )?passenger(?:'s)? (?:side|door)", "ego_side=right"},
    {"(?:hits?|hitting|strikes?|into)? ?(?:our|the ego's|ego's) (?:rear|back|tail)",
     "ego_side=rear"},
    {"(?:with |hits? |of )?(?:our|the ego's|ego's|the) front", "ego_side=front"},
    {SIDE "(?: side)?", "from_side="},
    // Road users.
    {"ambulance|police(?: car)?|fire (?:engine|truck)|emergency vehicle",
     "attacker_class=emergency_vehicle"},
    {"(?:garbage|refuse|delivery|box|semi|pickup) ?truck|tractor trailer|(?:articulated "
     ")?lorr(?:y|ies)|semi|hgv|trucks?",
     "attacker_class=truck"},
    {"bus(?:es)?|coach", "attacker_class=bus"},
    {"excavator|digger|tractor|road roller|construction vehicle",
     "attacker_class=construction_vehicle"},
    {"motor ?cycl(?:e|es|ist|ists)|motor ?bikes?", "attacker_class=motorcycle"},
    {"(?:bi)?cycl(?:e|es|ist|ists)|bikes?", "attacker_class=bicycle"},
    {"(?:e )?(?:kick )?scooters?|scooter riders?|personal mobility(?: devices?)?|segways?",
     "attacker_class=scooter"},
    {"child(?:ren)?|kids?|toddlers?|(?:school)?(?:boy|girl)s?|pupils?", "attacker_class=child"},
    {"joggers?|runners?|running (?:pedestrian|adult|person)", "attacker_class=runner"},
    {"pedestrians?|peds?|persons?|adults?|walkers?|jaywalkers?|on foot",
     "attacker_class=pedestrian"},
    {"cars?|taxi|cab|van|sedan|suv|hatchback", "attacker_class=car"},
    // Choices.
    {"(?:existing|recorded|logged)(?: vehicles?)?(?: only)?", "choice=existing"},
    {"(?:new|added|inserted|extra)(?: vehicles?)?", "choice=new"},
    {"strict(?: limits)?", "limits=strict"},
    {"any motion|implausible", "believable=false"},
    {"plausible|believable", "believable=true"},
    {"(?:any|some) (?:crash|collision|accident)|anything|something|whatever", "type=any"},
};

constexpr const char* kFillers =
    "a an the , and with of in on at to into onto from by for as is are be it its that this which "
    "where when we us our "
    "ego ego's my me i i'd i'll vehicle vehicles attacker type manoeuvre maneuver class side "
    "please create generate make "
    "give show run want need like see have would scenario scenarios case test collision collisions "
    "crash crashes "
    "accident hits hit hitting impact one other another's driver traffic lane lanes adjacent next "
    "path road street "
    "way while during while comes coming drives driving goes going does speed location front time "
    "s between "
    "number only but possible walking walks walk moving out along over across up back opposite of. "
    "there happens "
    "collides collide meets meet place t0 now can you then he she they something's while's overlap "
    "side's euro ncap 2026 2023 euroncap limits gap off vru ramp carriageway another travelling "
    "traveling straight proceeds rides riding runs t target both decel suddenly";

}  // namespace

const std::vector<PhraseRule>& phraseRules() {
  static const std::vector<PhraseRule> rules = [] {
    std::vector<PhraseRule> all = kFixedRules;
    const auto add = [&all](const std::string& field, std::string word) {
      PhraseRule rule{word, field + "=" + word};
      std::replace(rule.pattern.begin(), rule.pattern.end(), '_', ' ');
      all.push_back(rule);
    };
    for (const Manoeuvre manoeuvre : kManoeuvres) add("manoeuvre", toString(manoeuvre));
    for (const CollisionType type : kAllCollisionTypes) add("type", toString(type));
    for (const char* name : {"re", "od", "ho", "any"}) add("type", name);
    return all;
  }();
  return rules;
}

bool isFiller(const std::string& word) {
  static const std::set<std::string> fillers = [] {
    std::istringstream words(kFillers);
    return std::set<std::string>(std::istream_iterator<std::string>(words), {});
  }();
  return fillers.count(word) > 0;
}

}  // namespace forge
