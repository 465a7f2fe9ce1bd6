//! The cameras of the room: where the vehicle was a few milliseconds ago, nearly.

use nalgebra::{UnitQuaternion, Vector3};

use crate::{
    clock::{Clock, NS_PER_S},
    fault::{Fault, Faults},
    noise::{Noise, Source},
    parameters::{MotionCapture, VehicleParameters},
    planning::turned,
};

/// One pose as motion capture delivers it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseSample {
    /// When the cameras looked, ns of true time. The pose arrives a latency later.
    pub captured_ns: u64,
    /// Position of the centre of mass in the world, m.
    pub position_m: [f64; 3],
    /// Attitude, body to world, as a unit quaternion (w, x, y, z).
    pub attitude: [f64; 4],
}

/// The motion capture system.
#[derive(Clone, Debug)]
pub(crate) struct Cameras {
    parameters: MotionCapture,
    clock: Clock,
    timing: Noise,
    noise: Noise,
    /// Attitude of the frame of the markers in the body.
    offset: Vector3<f64>,
    /// The next frame that will arrive: when it is taken and when it arrives, ns. `None` if none ever will.
    frame: Option<(u64, u64)>,
    last: Option<PoseSample>,
}

impl Cameras {
    pub(crate) fn new(parameters: &VehicleParameters, seed: u64) -> Self {
        let parameters = parameters.motion_capture.clone();
        let offset = Noise::new(seed, Source::CaptureOffset).normal3(parameters.attitude_offset_rad);
        let mut cameras = Self {
            clock: Clock::new(parameters.rate_hz, 1.0),
            timing: Noise::new(seed, Source::CaptureTiming),
            noise: Noise::new(seed, Source::CaptureNoise),
            offset: Vector3::from(offset),
            frame: None,
            last: None,
            parameters,
        };
        cameras.frame = cameras.next_frame(&Faults::default());
        cameras
    }

    /// The marker frame stays as it is mounted.
    pub(crate) fn redraw_noise(&mut self, seed: u64) {
        self.timing = Noise::new(seed, Source::CaptureTiming);
        self.noise = Noise::new(seed, Source::CaptureNoise);
    }

    /// When the next frame is taken and when it arrives, ns; `u64::MAX` for never.
    pub(crate) fn next_ns(&self) -> (u64, u64) {
        self.frame.unwrap_or((u64::MAX, u64::MAX))
    }

    /// Moves the next frame out of times of silence.
    pub(crate) fn plan(&mut self, faults: &Faults) {
        if let Some((taken, _)) = self.frame
            && faults.active(Fault::MotionCaptureSilent, taken)
        {
            self.frame = self.next_frame(faults);
        }
    }

    fn next_frame(&mut self, faults: &Faults) -> Option<(u64, u64)> {
        loop {
            let taken = self.clock.next_ns();
            let free = faults.free_from_ns(Fault::MotionCaptureSilent, taken);
            if free == u64::MAX {
                return None;
            }
            if free > taken {
                self.clock.skip_to(free);
                continue;
            }
            self.clock.tick();
            let MotionCapture { latency_s, latency_jitter_s, drop_out, .. } = self.parameters;
            let latency = latency_s + latency_jitter_s * self.timing.share();
            if self.timing.share() >= drop_out {
                return Some((taken, taken.saturating_add(libm::round(latency * NS_PER_S) as u64)));
            }
        }
    }

    /// Takes the frame that is due at `now_ns`, and plans the next.
    pub(crate) fn take(
        &mut self,
        now_ns: u64,
        position: Vector3<f64>,
        attitude: UnitQuaternion<f64>,
        faults: &Faults,
    ) -> PoseSample {
        let seen = position + Vector3::from(self.noise.normal3(self.parameters.position_noise_m));
        let turn = self.offset + Vector3::from(self.noise.normal3(self.parameters.attitude_noise_rad));
        let q = turned(attitude, turn).into_inner();
        let mut pose =
            PoseSample { captured_ns: now_ns, position_m: seen.into(), attitude: [q.w, q.i, q.j, q.k] };
        match self.last {
            Some(last) if faults.active(Fault::MotionCaptureFrozen, now_ns) => {
                pose = PoseSample { captured_ns: now_ns, ..last };
            }
            _ => {}
        }
        self.last = Some(pose);
        self.frame = self.next_frame(faults);
        pose
    }
}
