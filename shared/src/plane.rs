//! The vertical plane of a maneuver, as the body sees it at the start.
//!
//! A planar maneuver needs no yaw: a vehicle that turns about a level axis at right angles to the plane tips its thrust
//! within the plane, whichever way its nose points. The axis is (−sin h, cos h, 0) in the body frame, where h is the
//! heading of the plane; it is fixed in the body *and* in the world, because everything turns about it.

/// A heading in the body frame, rad from forward towards left, by its cosine and sine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    cos: f32,
    sin: f32,
}

impl Plane {
    /// Straight ahead.
    pub const FORWARD: Self = Self { cos: 1.0, sin: 0.0 };

    /// The plane of a heading. One that is no number is straight ahead.
    pub fn new(heading_rad: f32) -> Self {
        if !heading_rad.is_finite() || heading_rad == 0.0 {
            return Self::FORWARD;
        }
        let (sin, cos) = libm::sincosf(heading_rad);
        Self { cos, sin }
    }

    /// Body rates (or angular accelerations) of a turn in the plane.
    pub fn turn(&self, about_axis: f32) -> [f32; 3] {
        [-self.sin * about_axis, self.cos * about_axis, 0.0]
    }

    /// A body vector in the plane's own axes: along the heading, to the left of it (the axis of turns in the plane), up.
    /// For rates and small angles: lateral, in the plane, yaw.
    pub fn axes(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x, z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_in_the_plane_has_no_other_part() {
        for i in -60..=60 {
            let plane = Plane::new(i as f32 * 0.1);
            let [lateral, in_plane, yaw] = plane.axes(plane.turn(3.0));
            assert!(lateral.abs() < 1e-6 && (in_plane - 3.0).abs() < 1e-6 && yaw == 0.0, "{i}");
        }
    }

    /// The right-hand rule by hand: a positive turn tips the thrust axis z towards the heading.
    #[test]
    fn a_positive_turn_tips_the_thrust_towards_the_heading() {
        for i in -60..=60 {
            let heading = i as f32 * 0.1;
            let [wx, wy, _] = Plane::new(heading).turn(1.0);
            // ω × z = (ω_y, −ω_x, 0).
            let (towards_x, towards_y) = (wy, -wx);
            assert!((towards_x - heading.cos()).abs() < 1e-6 && (towards_y - heading.sin()).abs() < 1e-6);
        }
    }

    #[test]
    fn straight_ahead_is_exact_and_nonsense_is_straight_ahead() {
        assert_eq!(Plane::new(0.0).turn(2.5), [0.0, 2.5, 0.0]);
        assert_eq!(Plane::new(-0.0), Plane::FORWARD);
        assert_eq!(Plane::new(f32::NAN), Plane::FORWARD);
        assert_eq!(Plane::new(f32::INFINITY), Plane::FORWARD);
    }
}
