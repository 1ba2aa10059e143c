/* SPDX-License-Identifier: MIT */
/* Names and sentences of the rules; switches without a default, so that a rule forgotten here is a compiler warning. */
#include "tdsp/oracle_check.h"

const char *tdsp_oracle_rule_name(tdsp_oracle_rule rule)
{
    switch (rule) {
    case TDSP_RULE_DECLARED: return "declared";
    case TDSP_RULE_ERROR: return "error";
    case TDSP_RULE_STATUS: return "status";
    case TDSP_RULE_ARRIVAL: return "arrival";
    case TDSP_RULE_REPEATABLE: return "repeatable";
    case TDSP_RULE_ORDER: return "order";
    case TDSP_RULE_NO_WAY: return "no_way";
    case TDSP_RULE_PATH_FORM: return "path_form";
    case TDSP_RULE_PATH_JOINS: return "path_joins";
    case TDSP_RULE_PATH_ENDS: return "path_ends";
    case TDSP_RULE_PATH_REPEATABLE: return "path_repeatable";
    case TDSP_RULE_DEPARTURE: return "departure";
    case TDSP_RULE_TOO_EARLY: return "too_early";
    case TDSP_RULE_BOTH_WAYS: return "both_ways";
    case TDSP_RULE_LATE: return "late";
    case TDSP_RULE_EARLY: return "early";
    case TDSP_RULE_ARRIVES: return "arrives";
    case TDSP_RULE_WITHIN: return "within";
    case TDSP_RULE_BOUNDS: return "bounds";
    case TDSP_RULE_REASON: return "reason";
    case TDSP_RULE_SLOW: return "slow";
    }
    return "unknown";
}

static const char *rule_text(tdsp_oracle_rule rule)
{
    switch (rule) {
    case TDSP_RULE_DECLARED: return "What the oracle declares is missing or out of its range";
    case TDSP_RULE_ERROR: return "A callback failed";
    case TDSP_RULE_STATUS: return "A callback returned a status that is no answer to its question";
    case TDSP_RULE_ARRIVAL: return "An arrival is not a finite number, or is before its departure";
    case TDSP_RULE_REPEATABLE: return "The same question was answered differently the second time";
    case TDSP_RULE_ORDER: return "A later departure travels shorter, or arrives earlier, than the oracle's monotone allows";
    case TDSP_RULE_NO_WAY: return "There is a way for a departure after one that had none";
    case TDSP_RULE_PATH_FORM: return "A path has no memory behind it, is too long, or has a leg that is not well formed";
    case TDSP_RULE_PATH_JOINS: return "A leg does not start when and where the one before ends";
    case TDSP_RULE_PATH_ENDS: return "A path does not start at its departure, or does not end at its arrival";
    case TDSP_RULE_PATH_REPEATABLE: return "The same question was answered by another path the second time";
    case TDSP_RULE_DEPARTURE: return "A latest departure is not a number in the range of its question";
    case TDSP_RULE_TOO_EARLY: return "An arrival is said to be too early though A(0) is not after it, or has a departure though A(0) is";
    case TDSP_RULE_BOTH_WAYS: return "There is a way in one direction and none in the other";
    case TDSP_RULE_LATE: return "A latest departure arrives later than was asked for";
    case TDSP_RULE_EARLY: return "A departure after the latest one arrives as early as was asked for";
    case TDSP_RULE_ARRIVES: return "The arrival that came with a latest departure is not that departure's";
    case TDSP_RULE_WITHIN: return "The bounds of an answer within a share are farther apart than that, or crossed";
    case TDSP_RULE_BOUNDS: return "The bounds of an answer within a share do not hold the exact answer";
    case TDSP_RULE_REASON: return "The last reason is none of the four reasons why there is no way";
    case TDSP_RULE_SLOW: return "A call took longer than allowed";
    }
    return "unknown";
}

const char *tdsp_oracle_finding_text(const tdsp_oracle_finding *finding)
{
    return finding ? rule_text(finding->rule) : "unknown";
}

const char *tdsp_oracle_callback_name(tdsp_oracle_callback callback)
{
    switch (callback) {
    case TDSP_ORACLE_MEMBERS: return "members";
    case TDSP_ORACLE_EARLIEST_ARRIVAL: return "earliest_arrival";
    case TDSP_ORACLE_LATEST_DEPARTURE: return "latest_departure";
    case TDSP_ORACLE_PATH: return "path";
    case TDSP_ORACLE_LAST_REASON: return "last_reason";
    case TDSP_ORACLE_EARLIEST_ARRIVAL_WITHIN: return "earliest_arrival_within";
    case TDSP_ORACLE_LATEST_DEPARTURE_BETWEEN: return "latest_departure_between";
    }
    return "unknown";
}
