// Whether a guided density pays: second moment times cost, on samples that did not shape it.
//
// A sample drawn with density p that was worth Q = (f / p)^2 tells the second moment that another
// density p' would give, E_p[Q p / p'], and the cost of its paths, E_p[c p' / p]. Judged on the
// samples that had shaped the density themselves, moments come out too low.
#pragma once

namespace aips {

class SecondMoments {
  public:
    /// Least gain at which guiding is switched on (once on, it stays while it gains anything).
    static constexpr double kGain = 1.15;

    /// One photon path: worth `score` and costing `cost`, drawn with density `drawn` where the
    /// plain one is `plain` and the guided one `guided` (all > 0).
    void add(double score, double cost, double drawn, double plain, double guided) {
        plain_.add(score * drawn / plain, cost * plain / drawn);
        guided_.add(score * drawn / guided, cost * guided / drawn);
        if (score > 0) scored_ += 1;
    }
    /// Keeps this share of what was counted.
    void forget(double share) {
        plain_.scale(share);
        guided_.scale(share);
        scored_ *= share;
    }
    /// Plain second moment times cost over the guided; 1 before anything was worth something.
    double gain() const {
        const double guided = guided_.product();
        return guided > 0 ? plain_.product() / guided : 1;
    }
    /// Samples that were worth something.
    double scored() const { return scored_; }
    /// The switch after what it was before.
    bool pays(bool on) const { return gain() > (on ? 1.0 : kGain); }

  private:
    struct Sums {
        double moment = 0, cost = 0;
        void add(double m, double c) {
            moment += m;
            cost += c;
        }
        void scale(double share) {
            moment *= share;
            cost *= share;
        }
        double product() const { return moment * cost; }
    };
    Sums plain_, guided_;
    double scored_ = 0;
};

}  // namespace aips
