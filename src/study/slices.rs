//! Long computations done slice by slice: written as asynchronous functions that pause now and then, and advanced by
//! whoever wants the answer, between two frames say. Nothing waits for anything else, so that no executor is needed.

use std::fmt;
use std::pin::{Pin, pin};
use std::task::{Context, Poll, Waker};

/// A computation under way.
pub(crate) struct Slices<T> {
    computation: Option<Pin<Box<dyn Future<Output = T>>>>,
}

impl<T> fmt::Debug for Slices<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.computation.is_some() { "Slices(under way)" } else { "Slices(done)" })
    }
}

impl<T> Slices<T> {
    /// Takes a computation up; nothing is done yet.
    pub(crate) fn new(computation: impl Future<Output = T> + 'static) -> Self {
        Self { computation: Some(Box::pin(computation)) }
    }

    /// Goes on to the next pause; the answer where that is the end, once.
    pub(crate) fn advance(&mut self) -> Option<T> {
        let computation = self.computation.as_mut()?;
        match computation.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            Poll::Ready(answer) => {
                self.computation = None;
                Some(answer)
            }
            Poll::Pending => None,
        }
    }
}

/// Carries a computation through at once.
pub(crate) fn whole<T>(computation: impl Future<Output = T>) -> T {
    let mut computation = pin!(computation);
    loop {
        if let Poll::Ready(answer) = computation.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            return answer;
        }
    }
}

/// Ends a slice.
pub(crate) async fn pause() {
    let mut paused = false;
    std::future::poll_fn(
        |_| if std::mem::replace(&mut paused, true) { Poll::Ready(()) } else { Poll::Pending },
    )
    .await;
}

#[cfg(test)]
mod tests {
    use super::*;

    async fn sum(pauses: u32) -> u32 {
        let mut sum = 0;
        for value in 1..=pauses {
            sum += value;
            pause().await;
        }
        sum
    }

    #[test]
    fn every_pause_ends_a_slice_and_the_answer_is_the_same_at_once() {
        let mut slices = Slices::new(sum(3));
        assert_eq!([slices.advance(), slices.advance(), slices.advance()], [None; 3]);
        assert_eq!((slices.advance(), slices.advance()), (Some(6), None));
        assert_eq!(whole(sum(3)), 6);
    }
}
