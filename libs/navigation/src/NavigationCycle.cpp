#include <bslnav/navigation/NavigationCycle.h>
#include <bslnav/navigation/ReactivePlanner.h>
#include <bslnav/planning/DwaPlanner.h>
#include <mrpt/system/CTicTac.h>

#include <cmath>

namespace bslnav {
namespace {

std::unique_ptr<LocalPlanner> makeLocalPlanner(const NavigationParameters& p,
                                               const FootprintCover& cover) {
  if (p.navigator.type == NavigatorType::Dwa)
    return std::make_unique<DwaPlanner>(p.dwa, p.limits, cover, p.cycle.period_s);
  return std::make_unique<ReactivePlanner>(p.navigator, p.dwa, p.limits, cover, p.footprint,
                                           p.cycle.period_s);
}

StoppingAbility abilityOf(const NavigationParameters& p) {
  return stoppingAbility(p.limits, p.guard, p.footprint.circumscribedRadius_m(), p.cycle.period_s);
}

}  // namespace

NavigationCycle::NavigationCycle(const NavigationParameters& parameters,
                                 const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map)
    : limits_(parameters.limits),
      period_s_(parameters.cycle.period_s),
      surroundings_(parameters, map),
      route_(parameters),
      movers_(parameters.movers, abilityOf(parameters), parameters.guard),
      approach_(parameters.movers, abilityOf(parameters), parameters.guard.personSpeed_mps,
                parameters.limits.maxSpeed_mps),
      motionPlanner_(parameters.motion, parameters.recovery,
                     makeLocalPlanner(parameters, surroundings_.footprintCover()),
                     parameters.limits, surroundings_.footprintCover(), parameters.cycle.period_s) {
  record_.index = -1;
  if (parameters.guard.enabled)
    guard_.emplace(parameters.guard, parameters.limits,
                   parameters.footprint.circumscribedRadius_m(), parameters.cycle.period_s);
}

void NavigationCycle::setGoals(std::vector<mrpt::math::TPose2D> goals) {
  route_.setGoals(std::move(goals));
  motionPlanner_.reset();
}

const CycleRecord& NavigationCycle::step(const SensorFrame& frame) {
  mrpt::system::CTicTac whole, stage;
  whole.Tic();
  ++record_.index;
  surroundings_.update(frame, record_);
  const auto base = commandBase(frame.twist);
  record_.motion = {};
  record_.motion.command = brake(base, limits_, period_s_);
  record_.replanned = false;
  record_.guard = {};
  if (record_.health != CycleRecord::Health::Ok) {
    motionPlanner_.forgetProgress();
    if (guard_) guard_->finishBlind(record_);
  } else if (route_.empty()) {
    record_.path.clear();
    record_.pathStatus = PathResult::Status::Found;
  } else {
    stage.Tic();
    route_.update(surroundings_, motionPlanner_.wantsReplan(), record_);
    record_.times.globalPlan_s = stage.Tac();
    stage.Tic();
    move(base);
    record_.times.motion_s = stage.Tac();
  }
  record_.times.total_s = whole.Tac();
  return record_;
}

void NavigationCycle::move(const mrpt::math::TTwist2D& base) {
  const People* people = surroundings_.people();
  const Guard* guard =
      guard_ ? &guard_->begin(record_, people->frontier(), people->stamp_s()) : nullptr;
  if (guard_ && guard_->isWaiting()) motionPlanner_.forgetProgress();
  MotionInput input{record_.time_s, record_.mapFromRobot, record_.twist,         base,
                    record_.path,   route_.goal(),        route_.passWithin_m(), guard};
  if (people) {
    movers_.begin(record_.mapFromRobot, people->movers());
    input.movers = &movers_;
    input.looksBehind = people->looksBehind();
    input.maxSpeed_mps =
        approach_.speed_mps({people->seen(), people->movers()}, record_.path, record_.mapFromRobot);
  }
  record_.motion = motionPlanner_.step(input, surroundings_.localCosts());
  if (record_.motion.planned) record_.dwa = motionPlanner_.dwa();
  if (guard_) guard_->finish(base, people->frontier(), record_);
}

mrpt::math::TTwist2D NavigationCycle::commandBase(const mrpt::math::TTwist2D& measured) const {
  const auto& last = record_.motion.command;
  const bool known =
      std::isfinite(measured.vx) && std::isfinite(measured.vy) && std::isfinite(measured.omega);
  if (!known) return last;  // then the robot is taken to do as it was told
  return record_.index == 0 ? measured : bslnav::commandBase(measured, last, limits_);
}

}  // namespace bslnav
